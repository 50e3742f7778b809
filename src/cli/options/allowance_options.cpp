#include "cli/options/allowance_options.hpp"

#include "golden/pictures/rules.hpp"

#include <CLI/CLI.hpp>

namespace simreel::cli {

void AllowanceOptions::add(CLI::App& command) {
  command.add_flag("--ignore-antialiased", ignoreAntialiased,
                   "Leave out pixels of smoothed edges, as pixelmatch and odiff find them");
  command
      .add_option("--search-radius", searchRadius,
                  "A pixel may be found so many pixels away, within --max-channel-diff, and the baseline's "
                  "likewise [0 to 16]")
      ->check(CLI::Range(0, golden::largestSearchRadius));
  command.add_option("--mask", mask,
                     "Picture of the compared size: pixels do not count where it is not black");
}

}  // namespace simreel::cli

#include "cli/options/allowance_options.hpp"

#include "golden/pictures/rules.hpp"

#include <CLI/CLI.hpp>

namespace simreel::cli {

void AllowanceOptions::add(CLI::App& command) {
  command.add_flag(
      "--ignore-antialiased", ignoreAntialiased,
      "Ignore pixels of smoothed edges, which are found by the method of pixelmatch and odiff");
  command
      .add_option("--search-radius", searchRadius,
                  "Ignore a pixel that moved: each picture has the other's colour, within "
                  "--max-channel-diff, at most this many pixels away [0 to 16]")
      ->check(CLI::Range(0, golden::largestSearchRadius));
  command.add_option("--mask", mask, "Picture of the same size: pixels do not count where it is not black");
}

}  // namespace simreel::cli

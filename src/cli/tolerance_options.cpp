#include "cli/tolerance_options.hpp"

#include "golden/tolerance.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

struct Flag {
  const char* field;
  double least, most;
  const char* doc;
};
constexpr Flag flags[] = {
    {"max_channel_diff", 0, 255, "A pixel differs when a channel is further apart than this"},
    {"max_diff_pixels", 0, 1e12, "Pixels that may differ"},
    {"max_diff_ratio", 0, 1, "Share of all pixels that may differ"},
    {"window_size", 1, 4096, "Side of the densest window, pixels"},
    {"max_window_ratio", 0, 1, "Share of the densest window's pixels that may differ"},
    {"max_flip_mean", 0, 1, "Mean FLIP error"},
    {"hard_fail", 0, 255, "No channel of any pixel may be further apart than this, whatever else holds"},
};

}  // namespace

void ToleranceOptions::add(CLI::App& command) {
  for (const Flag& flag : flags) {
    std::string name = flag.field;
    std::replace(name.begin(), name.end(), '_', '-');
    command.add_option("--" + name, values[flag.field], flag.doc)->check(CLI::Range(flag.least, flag.most));
  }
}

std::map<std::string, double> ToleranceOptions::given() const {
  std::map<std::string, double> all;
  for (const auto& [field, value] : values)
    if (value) all[field] = *value;
  return all;
}

}  // namespace simreel::cli

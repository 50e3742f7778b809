#include "cli/tolerance_options.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

struct Flag {
  const char* field;
  double least, most;
  bool whole;
  const char* doc;
};
constexpr Flag flags[] = {
    {"max_channel_diff", 0, 255, true, "A pixel differs when a channel is further apart, 0 to 255"},
    {"max_diff_pixels", 0, 16384.0 * 16384, true, "Pixels that may differ"},
    {"max_diff_ratio", 0, 1, false, "Share of all pixels that may differ, 0 to 1"},
    {"window_size", 1, 16384, true, "N of the densest N x N window [16]"},
    {"max_window_ratio", 0, 1, false, "Share of that window's pixels that may differ, 0 to 1"},
    {"max_flip_mean", 0, 1, false, "Mean FLIP error, 0 to 1"},
    {"hard_fail", 0, 255, true, "No channel of any pixel may be further apart, whatever else holds"},
};

std::string flagName(const char* field) {
  std::string name = std::string("--") + field;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

}  // namespace

void ToleranceOptions::add(CLI::App& command) {
  for (const Flag& flag : flags) command.add_option(flagName(flag.field), values[flag.field], flag.doc);
}

std::map<std::string, double> ToleranceOptions::given() const {
  std::map<std::string, double> all;
  for (const Flag& flag : flags) {
    const auto found = values.find(flag.field);
    if (found == values.end() || !found->second) continue;
    const double value = *found->second;
    // NaN is outside every range.
    if (!(value >= flag.least && value <= flag.most) || (flag.whole && value != std::floor(value)))
      fail(ExitCode::usage, "{} takes a {} from {} to {}, not {}", flagName(flag.field),
           flag.whole ? "whole number" : "number", flag.least, flag.most, value);
    all[flag.field] = value;
  }
  return all;
}

}  // namespace simreel::cli

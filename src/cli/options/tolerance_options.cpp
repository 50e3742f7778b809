#include "cli/options/tolerance_options.hpp"

#include "base/error.hpp"
#include "scene/json/words.hpp"
#include "scene/test.hpp"

#include <cmath>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

std::string flagName(const char* field) {
  return "--" + scene::splitCamelCase(field, '-');
}

}  // namespace

void ToleranceOptions::add(CLI::App& command) {
  for (const scene::Bound& bound : scene::Tolerance().bounds())
    command.add_option(
        flagName(bound.name), values[bound.name],
        fmt::format("{} [{:g} to {:g}]", bound.spec.doc, bound.spec.range.min, bound.spec.range.max));
}

std::map<std::string, double> ToleranceOptions::given() const {
  std::map<std::string, double> all;
  for (const scene::Bound& bound : scene::Tolerance().bounds()) {
    const auto found = values.find(bound.name);
    if (found == values.end() || !found->second) continue;
    const double value = *found->second;
    const scene::Range& range = bound.spec.range;
    const bool whole = std::holds_alternative<int*>(bound.member);
    // The test is written as !(in range), so that it also rejects NaN.
    if (!(value >= range.min && value <= range.max) || (whole && value != std::floor(value)))
      fail(ExitCode::usage, "{} takes a {} from {:g} to {:g}, not {}", flagName(bound.name),
           whole ? "whole number" : "number", range.min, range.max, value);
    all[bound.name] = value;
  }
  return all;
}

}  // namespace simreel::cli

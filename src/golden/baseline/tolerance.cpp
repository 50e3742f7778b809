#include "golden/baseline/tolerance.hpp"

#include "base/error.hpp"
#include "golden/compare/compare.hpp"

#include <cmath>
#include <optional>

namespace simreel::golden {

namespace {

struct OptionalField {
  const char* name;
  std::optional<double> scene::Tolerance::*member;
};
constexpr OptionalField optionalFields[] = {{"max_diff_pixels", &scene::Tolerance::max_diff_pixels},
                                            {"max_diff_ratio", &scene::Tolerance::max_diff_ratio},
                                            {"max_window_ratio", &scene::Tolerance::max_window_ratio},
                                            {"max_flip_mean", &scene::Tolerance::max_flip_mean},
                                            {"hard_fail", &scene::Tolerance::hard_fail}};
constexpr const char* fieldNames[] = {"max_channel_diff", "max_diff_pixels",  "max_diff_ratio",
                                      "window_size",      "max_window_ratio", "max_flip_mean",
                                      "hard_fail"};

}  // namespace

std::span<const char* const> toleranceFields() {
  return fieldNames;
}

void setBound(scene::Tolerance& tolerance, const std::string& field, double value) {
  if (field == "max_channel_diff") {
    tolerance.max_channel_diff = static_cast<int>(std::lround(value));
    return;
  }
  if (field == "window_size") {
    tolerance.window_size = static_cast<int>(std::lround(value));
    return;
  }
  for (const OptionalField& optional : optionalFields) {
    if (field != optional.name) continue;
    tolerance.*optional.member = value;
    return;
  }
  SIMREEL_CHECK_EQ(field, "a field of the tolerance");
}

std::map<std::string, double> boundsInForce(const scene::Tolerance& tolerance) {
  std::map<std::string, double> bounds = {{"max_channel_diff", tolerance.max_channel_diff}};
  for (const OptionalField& optional : optionalFields)
    if (const auto& value = tolerance.*optional.member) bounds[optional.name] = *value;
  if (!tolerance.max_diff_pixels && !tolerance.max_diff_ratio)
    bounds["max_diff_ratio"] = allowedRatio(tolerance);
  if (tolerance.max_window_ratio) bounds["window_size"] = tolerance.window_size;
  return bounds;
}

}  // namespace simreel::golden

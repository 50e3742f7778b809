#include "golden/baseline/tolerance.hpp"

#include "base/error.hpp"
#include "golden/compare/compare.hpp"

#include <cmath>
#include <optional>

namespace simreel::golden {

void setBound(scene::Tolerance& tolerance, const std::string& field, double value) {
  for (const scene::Bound& bound : tolerance.bounds()) {
    if (field != bound.name) continue;
    if (int* const* whole = std::get_if<int*>(&bound.member))
      **whole = static_cast<int>(std::lround(value));
    else
      *std::get<std::optional<double>*>(bound.member) = value;
    return;
  }
  SIMREEL_CHECK_EQ(field, "a field of the tolerance");
}

scene::Tolerance strictTolerance(const std::map<std::string, double>& given) {
  scene::Tolerance tolerance;
  tolerance.maxChannelDiff = 0;
  for (const auto& [field, value] : given) setBound(tolerance, field, value);
  if (tolerance.maxDiffPixels || tolerance.maxDiffRatio) return tolerance;
  if (tolerance.maxWindowRatio || tolerance.maxFlipMean || tolerance.hardFail)
    tolerance.maxDiffRatio = 1;
  else
    tolerance.maxDiffPixels = 0;
  return tolerance;
}

std::map<std::string, double> boundsInForce(scene::Tolerance tolerance) {
  if (!tolerance.maxDiffPixels && !tolerance.maxDiffRatio) tolerance.maxDiffRatio = allowedRatio(tolerance);
  std::map<std::string, double> bounds;
  for (const scene::Bound& bound : tolerance.bounds())
    if (int* const* whole = std::get_if<int*>(&bound.member))
      bounds[bound.name] = **whole;
    else if (const auto& value = *std::get<std::optional<double>*>(bound.member))
      bounds[bound.name] = *value;
  if (!tolerance.maxWindowRatio) bounds.erase("windowSize");
  return bounds;
}

}  // namespace simreel::golden

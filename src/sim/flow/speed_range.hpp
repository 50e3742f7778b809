#pragma once
#include "scene/drawn_on.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/auto_range.hpp"

#include <optional>
#include <vector>

namespace simreel::sim {

/// Speeds of the first and the last colour of arrows or streamlines, in m/s.
struct SpeedRange {
  double low = 0;
  std::optional<double> high;  ///< if empty, the speed that the source states or that a first run measures
  AutoEnds ends;               ///< states that a first run measures `high`

  /// Declares "low" and "high". `leftOut` describes the default of "high".
  void describe(scene::Fields& fields, const char* highDoc, const char* leftOut);
  /// Returns the range if its high end is "auto".
  [[nodiscard]] std::vector<MeasuredRange> measured();
  /// Returns the last speed, which is above `low`. `fastest`: speed that the source states.
  [[nodiscard]] double last(double fastest) const;
};

/// Parameters of objects that show the velocities of another object.
class ShowsSpeedsOf : public scene::DrawnOn {};

/// Simulations whose shown speeds a first run measures.
class HasShownSpeeds {
 public:
  virtual ~HasShownSpeeds() = default;
  /// Returns the speeds (m/s) that the object shows now. Reads them back from the GPU.
  [[nodiscard]] virtual std::vector<float> shownSpeeds() const = 0;
};

}  // namespace simreel::sim

#pragma once
#include "sim/core/kind.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Parameters of the kind chart: curves over the picture of what other objects measure, over time.
struct ChartParameters : ObjectParameters {
  struct Curve {
    std::string of;                  ///< OBJECT.QUANTITY
    std::string label;               ///< empty: the quantity
    double per = 1;                  ///< of the quantity: 1 in the chart
    std::optional<glm::vec3> color;  ///< linear RGB

    [[nodiscard]] std::string object() const;
    [[nodiscard]] std::string quantity() const;
  };
  static constexpr std::size_t mostCurves = 4;  ///< of a drawable

  std::vector<Curve> curves;
  std::optional<double> low, high;  ///< at the chart's foot and top; none: round numbers around what was
  double seconds = 0;               ///< along its time axis, which grows when they are over
  float x = 0.025F, y = 0.67F;      ///< of its top left corner, fractions of the picture
  float width = 0.42F, height = 0.3F;

  void describe(scene::Fields& fields) override;
  [[nodiscard]] const char* drawnWith() const override { return "its \"curves\""; }
  void ports(Ports& ports) const override;
};

/// The ends of a scale.
struct ChartRange {
  double low = 0, high = 1;
};
/// A scale around numbers from `least` to `most`: its ends are whole numbers of a step, 1, 2 or 5 times a
/// power of ten, and two to four of those apart. Of what does not change: half of it around it.
[[nodiscard]] ChartRange roundRange(double least, double most);

}  // namespace simreel::sim

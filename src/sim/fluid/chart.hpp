#pragma once
#include "gl/element_array.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/carry_over.hpp"
#include "sim/core/drawable.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Curves over the picture of quantities of a fluid, as a scene says them.
struct FluidChartParameters {
  enum class Quantity { lift, drag, kineticEnergy, enstrophy, temperature, speed };
  struct Curve {
    Quantity of = Quantity::lift;
    double per = 1;                  ///< of the quantity: 1 in the chart
    std::optional<glm::vec3> color;  ///< linear RGB
  };
  std::vector<Curve> curves;
  double low = -1, high = 1;  ///< at the chart's foot and top
  double seconds = 0;         ///< along its time axis, which grows when they are over

  FluidChartParameters() : curves(1) {}
  void describe(scene::Fields& fields);
  /// Whether a curve is of what pushes obstacles.
  [[nodiscard]] bool showsForces() const;
};

/// One value a frame of each curve, as counts of a drawable: 0 at `low`, 2^24 at `high`.
class FluidChart {
 public:
  FluidChart() = default;
  FluidChart(const std::string& name, const FluidChartParameters& parameters, double frameSeconds);
  /// `measured`: FluidParameters::quantities(), in that order.
  void add(std::span<const double> measured);
  void carryOver(CarryOver& carry);
  void publish(Drawables& drawables) const;
  [[nodiscard]] const gl::Buffer& rows() const { return rows_.buffer(); }
  [[nodiscard]] int frames() const { return done_; }

 private:
  std::string name_;
  const FluidChartParameters* parameters_ = nullptr;
  double frameSeconds_ = 1;
  int done_ = 0, room_ = 0;
  gl::WordsArray rows_;
};

}  // namespace simreel::sim

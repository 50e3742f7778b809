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

/// Scene parameters of a chart that shows a fluid's quantities over the picture.
struct FluidChartParameters {
  enum class Quantity { lift, drag, kineticEnergy, enstrophy, temperature, speed };
  struct Curve {
    Quantity of = Quantity::lift;
    double per = 1;                  ///< Amount of the quantity that corresponds to 1 in the chart.
    std::optional<glm::vec3> color;  ///< Colour of the curve, linear RGB.
  };
  std::vector<Curve> curves;
  double low = -1, high = 1;  ///< Values at the bottom and the top of the chart.
  double seconds = 0;  ///< Length of the time axis in seconds; the axis grows when the run is longer.

  FluidChartParameters() : curves(1) {}
  void describe(scene::Fields& fields);
  /// Returns true if a curve shows a force on obstacles (lift or drag).
  [[nodiscard]] bool showsForces() const;
};

/// Records one value per frame and curve as counts of a Chart drawable: 0 at `low`, 2^24 at `high`.
class FluidChart {
 public:
  FluidChart() = default;
  FluidChart(const std::string& name, const FluidChartParameters& parameters, double frameSeconds);
  /// Adds a frame. `measured`: values in the order of FluidParameters::quantities().
  void add(std::span<const double> measured);
  void visitCheckpointData(CarryOver& carry);
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

#pragma once
#include "scene/fitted.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/fluid/chart.hpp"
#include "sim/fluid/tracers.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/grid/field_display.hpp"
#include "sim/grid/strokes.hpp"
#include "sim/ports/color_scale.hpp"

#include <filesystem>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// One side of a fluid's grid.
struct FluidSide {
  /// Boundary condition: wall is a no-slip wall, slip a free-slip wall, inflow has a prescribed velocity,
  /// open has pressure 0. The values match glsl/fluid/model.glsl.
  enum class Kind { wall, slip, inflow, open, periodic };
  Kind kind = Kind::wall;
  scene::Animated<glm::vec3> velocity =
      glm::vec3(0);  ///< Velocity in cells/s of a wall along itself, or of an inflow.
  /// Velocity profile across an inflow: constant, or a parabola with `velocity` at the centre and 0 at the
  /// ends.
  enum class Profile { even, parabola };
  Profile profile = Profile::even;
};

/// Fixed or moving obstacle in a fluid.
struct FluidObstacle {
  enum class Shape { circle, box, image };
  Shape shape = Shape::circle;
  scene::Animated<glm::vec3> center =
      glm::vec3(0);                    ///< Centre of the obstacle in cells (third component unused).
  float radius = 8;                    ///< Radius of a circle in cells.
  glm::vec3 extent{16, 16, 0};         ///< Width and height of a box in cells, at least 1.
  scene::Animated<float> turn = 0.0F;  ///< Clockwise rotation about the centre, in degrees.
  std::filesystem::path image;         ///< Image whose bright pixels are solid.
  float threshold = 0.5F;              ///< Minimum brightness of solid pixels, 0 to 1.
  float scale = 1;                     ///< Size of an image pixel in cells.
  bool measured = true;                ///< True if the measured drag and lift include this obstacle.

  [[nodiscard]] bool moves() const { return center.moves() || turn.moves(); }
};

/// Stroke that sets velocity, temperature or dye, or applies a force. In each substep, the velocity,
/// temperature or dye of a cell moves towards the value that the stroke sets, by the fraction `value` of
/// the difference.
struct FluidStroke : StrokeParameters {
  bool setsVelocity = false, setsTemperature = false, setsDye = false;
  scene::Animated<glm::vec3> velocity = glm::vec3(0);  ///< Velocity set by the stroke, in cells/s.
  scene::Animated<float> temperature = 0.0F;
  scene::Animated<glm::vec3> dye = glm::vec3(0);    ///< Dye colour set by the stroke, RGB.
  scene::Animated<glm::vec3> force = glm::vec3(0);  ///< Acceleration applied by the stroke, in cells/s^2.
  float soft = 0.5F;  ///< Fraction of the radius over which the stroke's effect falls to 0 towards its rim.
};

/// Scene parameters of a fluid: incompressible flow. Lengths are in cells; y and v point down in the
/// picture.
struct FluidParameters : ObjectParameters, HasColorRange, ShowsQuantity, scene::Covering, scene::Fitted {
  enum class Advection {
    macCormack,
    semiLagrangian,
    cubic
  };  // The values match ADVECTION of glsl/fluid/grid.glsl.
  enum class Show { dye, speed, vorticity, temperature, pressure, lines };
  enum class Look { light, ink, fire };
  glm::ivec2 size{320, 180};  ///< Grid size in cells.
  FluidSide left, right, top, bottom;
  float speed = 450;            ///< Expected maximum flow speed in cells/s.
  bool ownSpeed = false;        ///< true if the scene gives the speed
  std::optional<int> substeps;  ///< Substeps per frame; if empty, chosen from speed and viscosity.
  float courant = 2.5F;         ///< Distance in cells that fluid with the speed `speed` moves in a substep.
  Advection advection = Advection::macCormack;
  scene::Animated<float> viscosity = 0.0F;    ///< Kinematic viscosity in cells^2/s.
  scene::Animated<float> confinement = 0.0F;  ///< Strength of vorticity confinement in 1/s.
  scene::Animated<float> lift = 0.0F;         ///< Upward acceleration at temperature 1, in cells/s^2.
  float cooling = 0;                          ///< Rate at which temperature decays, in 1/s.
  scene::Animated<float> dyeWeight = 0.0F;    ///< Downward acceleration where the dye is (1, 1, 1), in
                                              ///< cells/s^2.
  glm::vec3 flow{0};                          ///< Initial uniform velocity in cells/s.
  int cycles = 16;                            ///< Maximum number of multigrid cycles per projection.
  std::vector<FluidObstacle> obstacles;
  bool obstaclesSlip = false;
  glm::vec3 obstacleColor{0.03F, 0.03F, 0.035F};  ///< Obstacle colour, linear RGB.
  std::vector<FluidStroke> strokes;
  bool ownStrokes = false;  ///< true if the scene gives the strokes
  Show show = Show::dye;
  Look look = Look::light;
  FluidPlane plane;
  std::optional<TracerParameters> tracers;
  float brightness = 1.1F;
  glm::vec3 paper{0.003F, 0.004F, 0.009F};  ///< Background colour where there is no dye, linear RGB.
  int lineDetail = 4;                       ///< Pixels per cell along each axis in the display of flow
                                            ///< lines.
  double lineRate = 0.8;                    ///< Frequency in 1/s of the ripples at a fixed point of a flow
                                            ///< line.
  FieldDisplay display;
  std::optional<FluidChartParameters> chart;

  FluidParameters();
  void describe(scene::Fields& fields) override;
  void fitPicture(glm::ivec2 picture) override;
  [[nodiscard]] std::vector<MeasuredRange> measuredRanges() override { return display.measuredRanges(); }
  [[nodiscard]] const char* drawnWith() const override { return "its \"display\""; }
  [[nodiscard]] ShownQuantity shownQuantity() const override;
  [[nodiscard]] std::optional<scene::Box> framedAlone() const override {
    if (display.layer != FieldDisplay::Layer::none) return std::nullopt;
    return boxOfPlane(plane, size);
  }
  void leaveRoom(glm::vec2 room) override { display.room = room; }
  [[nodiscard]] Extent covering() const override { return display.covering(); }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t minLargestBufferBytes() const override {
    return std::int64_t{16} * (size.x + 2) * (size.y + 2);
  }
  /// Names of the additional fields, published as OBJECT.PART.
  static std::vector<std::string> fieldParts() {
    return {"u", "v", "temperature", "pressure", "red", "green", "blue"};
  }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;

  [[nodiscard]] bool wrapsX() const { return left.kind == FluidSide::Kind::periodic; }
  [[nodiscard]] bool wrapsY() const { return top.kind == FluidSide::Kind::periodic; }
  /// heats() returns true if a stroke sets a temperature, dyes() if a stroke sets dye, and sinks() if dye
  /// has weight. remarkIdle() reports parameters that have no effect.
  void remarkIdle(scene::Fields& fields) const;
  [[nodiscard]] bool heats() const;
  [[nodiscard]] bool dyes() const;
  [[nodiscard]] bool sinks() const;
  [[nodiscard]] bool confines() const;
  [[nodiscard]] bool viscous() const;
  [[nodiscard]] bool obstaclesMove() const;
  /// Returns true if enclosed pockets of fluid may have to grow or shrink.
  [[nodiscard]] bool pocketsGrow() const;
};

/// Maximum ratio of max|div u| to max|u| after a projection.
inline constexpr float maxFluidDivergence = 1e-5F;
/// The solver stops its cycles when it estimates the ratio to be below this value. The margin is for
/// rounding errors of the flow, which add to the residual divergence.
inline constexpr float aimedFluidDivergence = 0.8F * maxFluidDivergence;
/// If the speed exceeds the expected speed by this factor, the flow counts as lost and the run ends.
inline constexpr float lostFluidSpeed = 1e3F;

}  // namespace simreel::sim

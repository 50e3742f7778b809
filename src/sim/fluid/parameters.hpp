#pragma once
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/fluid/chart.hpp"
#include "sim/fluid/tracers.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/grid/field_display.hpp"
#include "sim/grid/strokes.hpp"

#include <filesystem>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// One border of a fluid's grid.
struct FluidSide {
  /// wall: no slip. inflow: the velocity is given. open: pressure 0. As glsl/fluid/model.glsl numbers them.
  enum class Kind { wall, slip, inflow, open, periodic };
  Kind kind = Kind::wall;
  scene::Animated<glm::vec3> velocity = glm::vec3(0);  ///< cells/s: of a wall along itself, of an inflow
  /// Of an inflow: what goes across the side is even, or `velocity` in the middle and 0 at the ends.
  enum class Profile { even, parabola };
  Profile profile = Profile::even;
};

/// What stands in a fluid, or moves through it.
struct FluidObstacle {
  enum class Shape { circle, box, image };
  Shape shape = Shape::circle;
  scene::Animated<glm::vec3> center = glm::vec3(0);  ///< cells (third unused)
  float radius = 8;                                  ///< cells, of a circle
  glm::vec3 extent{16, 16, 0};                       ///< cells: width and height of a box, 1 at least
  scene::Animated<float> turn = 0.0F;                ///< degrees, clockwise, about the centre
  std::filesystem::path image;                       ///< its light is solid
  float threshold = 0.5F;                            ///< of the light, 0 to 1
  float scale = 1;                                   ///< cells a pixel of the image
  bool measured = true;                              ///< whether drag and lift are its own, too

  [[nodiscard]] bool moves() const { return center.moves() || turn.moves(); }
};

/// A stroke that sets velocity, temperature or dye, or pushes. Its `value` is the part of the way that what
/// it sets goes in each substep.
struct FluidStroke : StrokeParameters {
  bool setsVelocity = false, setsTemperature = false, setsDye = false;
  scene::Animated<glm::vec3> velocity = glm::vec3(0);  ///< cells/s
  scene::Animated<float> temperature = 0.0F;
  scene::Animated<glm::vec3> dye = glm::vec3(0);    ///< RGB
  scene::Animated<glm::vec3> force = glm::vec3(0);  ///< cells/s^2
  float soft = 0.5F;  ///< part of the radius over which it fades towards its rim
};

/// Incompressible flow as a scene says it. Lengths are in cells; v and y grow down the picture.
struct FluidParameters : ObjectParameters {
  enum class Advection { macCormack, semiLagrangian, cubic };  // as ADVECTION of glsl/fluid/grid.glsl
  enum class Show { dye, speed, vorticity, temperature, pressure, lines };
  enum class Look { light, ink, fire };
  glm::ivec2 size{320, 180};  ///< cells
  FluidSide left, right, top, bottom;
  float speed = 450;            ///< cells/s that the flow is expected to have at most
  std::optional<int> substeps;  ///< a frame; none: as speed and viscosity ask for
  float courant = 2.5F;         ///< cells that the greatest speed goes in a substep
  Advection advection = Advection::macCormack;
  scene::Animated<float> viscosity = 0.0F;    ///< cells^2/s
  scene::Animated<float> confinement = 0.0F;  ///< 1/s
  scene::Animated<float> lift = 0.0F;         ///< cells/s^2, up, of a temperature of 1
  float cooling = 0;                          ///< 1/s
  scene::Animated<float> dyeWeight = 0.0F;    ///< cells/s^2, down, of a dye of (1, 1, 1)
  glm::vec3 flow{0};                          ///< cells/s: everywhere at the start
  int cycles = 16;                            ///< of the multigrid at most, for each projection
  std::vector<FluidObstacle> obstacles;
  bool obstaclesSlip = false;
  glm::vec3 obstacleColor{0.03F, 0.03F, 0.035F};  ///< linear RGB
  std::vector<FluidStroke> strokes;
  Show show = Show::dye;
  Look look = Look::light;
  FluidPlane plane;
  std::optional<TracerParameters> tracers;
  float brightness = 1.1F;
  glm::vec3 paper{0.003F, 0.004F, 0.009F};  ///< linear RGB where there is no dye
  int lineDetail = 4;                       ///< places a cell on a side in which lines are drawn
  double lineRate = 0.8;                    ///< 1/s: ripples that run through a place of a line
  FieldDisplay display;
  std::optional<FluidChartParameters> chart;

  FluidParameters();
  void describe(scene::Fields& fields) override;
  [[nodiscard]] const char* drawnWith() const override { return "its \"display\""; }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t leastBlockBytes() const override {
    return std::int64_t{16} * (size.x + 2) * (size.y + 2);
  }
  /// Fields beside the one of its name, as OBJECT.PART.
  static std::vector<std::string> fieldParts() {
    return {"u", "v", "temperature", "pressure", "red", "green", "blue"};
  }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;

  [[nodiscard]] bool wrapsX() const { return left.kind == FluidSide::Kind::periodic; }
  [[nodiscard]] bool wrapsY() const { return top.kind == FluidSide::Kind::periodic; }
  /// Whether there is temperature at all, dye, and dye that is heavy.
  void remarkIdle(scene::Fields& fields) const;
  [[nodiscard]] bool heats() const;
  [[nodiscard]] bool dyes() const;
  [[nodiscard]] bool sinks() const;
  [[nodiscard]] bool confines() const;
  [[nodiscard]] bool viscous() const;
  [[nodiscard]] bool obstaclesMove() const;
  /// Whether closed pockets may have to grow or shrink.
  [[nodiscard]] bool pocketsGrow() const;
};

/// max|div u| over max|u| after a projection, at most.
inline constexpr float maxFluidDivergence = 1e-5F;
/// Cycles end when what they leave by their own account is below this; rounding adds to that in the flow.
inline constexpr float aimedFluidDivergence = 0.8F * maxFluidDivergence;
/// Times the speed that is expected: a flow that is faster than that has lost its way, and the run ends.
inline constexpr float lostFluidSpeed = 1e3F;

}  // namespace simreel::sim

#pragma once
#include "scene/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/grid/field_display.hpp"
#include "sim/grid/strokes.hpp"

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
};

/// What stands in a fluid.
struct FluidObstacle {
  enum class Shape { circle, box };
  Shape shape = Shape::circle;
  glm::vec3 center{0};          ///< cells (third unused)
  float radius = 8;             ///< cells, of a circle
  glm::vec3 extent{16, 16, 0};  ///< cells: width and height of a box
  float turn = 0;               ///< degrees, of a box

  /// Whether the point (x, y), in cells, lies within.
  [[nodiscard]] bool contains(double x, double y) const;
};

/// A stroke that sets velocity, temperature or dye, or pushes. Its `value` is the part of the way that what
/// it sets goes in each substep.
struct FluidStroke : StrokeParameters {
  bool setsVelocity = false, setsTemperature = false, setsDye = false;
  glm::vec3 velocity{0};  ///< cells/s
  float temperature = 0;
  glm::vec3 dye{0};    ///< RGB
  glm::vec3 force{0};  ///< cells/s^2
  float soft = 0.5F;   ///< part of the radius over which it fades towards its rim
};

/// Incompressible flow (SPEC 9) as a scene says it. Lengths are in cells; v and y grow down the picture.
struct FluidParameters : ObjectParameters {
  enum class Advection { macCormack, semiLagrangian };
  enum class Show { dye, speed, vorticity, temperature, pressure, lines };
  enum class Look { light, ink, fire };
  glm::ivec2 size{320, 180};  ///< cells
  FluidSide left, right, top, bottom;
  float speed = 420;            ///< cells/s that the flow is expected to have at most
  std::optional<int> substeps;  ///< a frame; none: as speed and viscosity ask for
  float courant = 2.5F;         ///< cells that the greatest speed goes in a substep
  Advection advection = Advection::macCormack;
  scene::Animated<float> viscosity = 0.0F;    ///< cells^2/s
  scene::Animated<float> confinement = 0.0F;  ///< 1/s
  scene::Animated<float> lift = 0.0F;         ///< cells/s^2, up, of a temperature of 1
  float cooling = 0;                          ///< 1/s
  scene::Animated<float> dyeWeight = 0.0F;    ///< cells/s^2, down, of a dye of (1, 1, 1)
  glm::vec3 flow{0};                          ///< cells/s: everywhere at the start
  int cycles = 24;                            ///< of the multigrid at most, for each projection
  std::vector<FluidObstacle> obstacles;
  bool obstaclesSlip = false;
  glm::vec3 obstacleColor{0.03F, 0.03F, 0.035F};  ///< linear RGB
  std::vector<FluidStroke> strokes;
  Show show = Show::dye;
  Look look = Look::light;
  float brightness = 1.1F;
  glm::vec3 paper{0.003F, 0.004F, 0.009F};  ///< linear RGB where there is no dye
  int lineDetail = 4;                       ///< places a cell on a side in which lines are drawn
  double lineRate = 0.8;                    ///< 1/s: ripples that run through a place of a line
  FieldDisplay display;

  FluidParameters();
  void describe(scene::Fields& fields) override;
  [[nodiscard]] bool isField() const override { return true; }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;

  [[nodiscard]] bool wrapsX() const { return left.kind == FluidSide::Kind::periodic; }
  [[nodiscard]] bool wrapsY() const { return top.kind == FluidSide::Kind::periodic; }
  /// Whether there is temperature at all, dye, and dye that is heavy.
  [[nodiscard]] bool heats() const;
  [[nodiscard]] bool dyes() const;
  [[nodiscard]] bool sinks() const;
  [[nodiscard]] bool confines() const;
  /// Whether there is friction or confinement.
  [[nodiscard]] bool rubs() const;
};

/// max|div u| over max|u| after a projection, at most.
inline constexpr float maxFluidDivergence = 1e-5F;

}  // namespace simreel::sim

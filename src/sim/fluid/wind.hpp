#pragma once
#include "gl/kernel/fields.hpp"
#include "glsl/common/cpp.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/port.hpp"
#include "sim/fluid/array.hpp"

#include <functional>
#include <span>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::shader {
#include "glsl/fluid/wind_types.glsl"
}  // namespace simreel::shader

namespace simreel::sim {

/// Position and orientation of a fluid's rectangle in the world. Without rotation it stands upright like a
/// picture that is viewed along -z: x of the fluid points right and y down.
struct FluidPlane {
  glm::vec3 position{0};  ///< Centre of the rectangle in metres.
  glm::vec3 rotation{0};  ///< Rotation of the rectangle in degrees about x, then y, then z.
  float cell = 0.05F;     ///< Cell width in metres.

  void describe(scene::Fields& fields);
};

/// Returns the bounding box in the world of a rectangle of `size` cells.
[[nodiscard]] scene::Box boxOfPlane(const FluidPlane& plane, glm::ivec2 size);

/// Returns the data with which other simulations sample a fluid of `size` cells as their wind
/// (glsl/fluid/wind_model.glsl). The CPU twins use it, too.
[[nodiscard]] shader::WindGrid fluidWindGrid(const FluidPlane& plane, glm::ivec2 size);

/// Part of a kernel interface: members of glsl/fluid/wind_array.glsl, used if WIND is defined.
struct FluidWindPart {
  gl::Uniform<"windGrid.across", glm::vec4> across;
  gl::Uniform<"windGrid.down", glm::vec4> down;
  gl::Uniform<"windGrid.alongX", glm::vec3> alongX;
  gl::Uniform<"windGrid.alongY", glm::vec3> alongY;
  gl::Uniform<"windGrid.size", glm::ivec2> size;
  gl::In<"windCells"> cells;
};

/// Wind that other simulations get from a fluid, in the state after the fluid's latest step. There is no
/// wind outside the fluid's rectangle. Perpendicular to the rectangle's plane the wind is constant.
class FluidWind {
 public:
  static const PortInfo port;

  /// `flow` returns the array that holds the flow when it is called. `speed` is the expected maximum speed
  /// in cells/s.
  FluidWind(const FluidPlane& plane, glm::ivec2 size, float speed, std::function<const FluidArray&()> flow);
  /// Creates a constant wind. x and y of `cells` are the flow (cells/s) at the left and top faces, and z
  /// the speed in the middle, row by row, including a ring of one cell: (size.x + 2) (size.y + 2) elements.
  FluidWind(const std::string& name, const FluidPlane& plane, glm::ivec2 size,
            std::span<const glm::vec4> cells);
  ~FluidWind() = default;
  FluidWind(const FluidWind&) = delete;
  FluidWind& operator=(const FluidWind&) = delete;
  FluidWind(FluidWind&&) = delete;
  FluidWind& operator=(FluidWind&&) = delete;

  [[nodiscard]] FluidWindPart part() const;
  [[nodiscard]] const FluidPlane& plane() const { return plane_; }
  [[nodiscard]] const shader::WindGrid& grid() const { return grid_; }
  [[nodiscard]] float speed() const { return speed_; }

 private:
  FluidPlane plane_;
  shader::WindGrid grid_;
  float speed_;
  std::function<const FluidArray&()> flow_;
  gl::Buffer still_;  ///< Flow of a constant wind.
  FluidArray stillFlow_;
};

}  // namespace simreel::sim

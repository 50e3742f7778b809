#pragma once
#include "gl/kernel/fields.hpp"
#include "glsl/common/cpp.hpp"
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

/// Where a fluid's rectangle lies in the world. Unturned it stands upright, as a picture that is looked at
/// along -z: the fluid's x to the right, its y down.
struct FluidPlane {
  glm::vec3 position{0};  ///< m, of its middle
  glm::vec3 rotation{0};  ///< degrees, about x, then y, then z
  float cell = 0.05F;     ///< m, width of a cell
};

/// What those that take a fluid of `size` cells as their wind are told of it (glsl/fluid/wind_model.glsl);
/// shared with the CPU twins.
[[nodiscard]] shader::WindGrid fluidWindGrid(const FluidPlane& plane, glm::ivec2 size);

/// What glsl/fluid/wind_array.glsl is given where WIND is defined, a part of a kernel's interface.
struct FluidWindPart {
  gl::Uniform<"windGrid.across", glm::vec4> across;
  gl::Uniform<"windGrid.down", glm::vec4> down;
  gl::Uniform<"windGrid.alongX", glm::vec3> alongX;
  gl::Uniform<"windGrid.alongY", glm::vec3> alongY;
  gl::Uniform<"windGrid.size", glm::ivec2> size;
  gl::In<"windCells"> cells;
};

/// A fluid as the wind of others, in the state in which its latest step left it. Outside of its rectangle
/// there is none; before and behind its plane there is what the plane has.
class FluidWind {
 public:
  static const PortInfo port;

  /// `flow`: the array that holds it at the moment of the call.
  /// `speed` (cells/s): the greatest that is expected.
  FluidWind(const FluidPlane& plane, glm::ivec2 size, float speed, std::function<const FluidArray&()> flow);
  /// A wind that does not change. `cells`: x and y are the flow (cells/s) at the left and the top face of
  /// each cell, row by row, with a ring of one cell around them: (size.x + 2) (size.y + 2) in all.
  FluidWind(const std::string& name, const FluidPlane& plane, glm::ivec2 size,
            std::span<const glm::vec4> cells);
  ~FluidWind() = default;
  FluidWind(const FluidWind&) = delete;
  FluidWind& operator=(const FluidWind&) = delete;
  FluidWind(FluidWind&&) = delete;
  FluidWind& operator=(FluidWind&&) = delete;

  [[nodiscard]] FluidWindPart part() const;
  [[nodiscard]] const shader::WindGrid& grid() const { return grid_; }
  [[nodiscard]] float speed() const { return speed_; }

 private:
  shader::WindGrid grid_;
  float speed_;
  std::function<const FluidArray&()> flow_;
  gl::Buffer still_;  ///< of a wind that does not change
  FluidArray stillFlow_;
};

}  // namespace simreel::sim

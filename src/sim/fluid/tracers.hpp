#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/carry_over.hpp"
#include "sim/core/simulation.hpp"
#include "sim/fluid/wind.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::shader {
#include "glsl/fluid/tracers/tracer_types.glsl"
}  // namespace simreel::shader

namespace simreel::sim {

/// Specks that show a fluid's velocity.
struct TracerParameters {
  int count = 2000;
  float seconds = 4;                   ///< mean life, after which one begins anew elsewhere
  float streak = 0.35F;                ///< s, in which what they drew fades to 1/e
  glm::vec3 color{0.9F, 0.95F, 1.0F};  ///< linear RGB
  float brightness = 1;
  void describe(scene::Fields& fields);
};

/// What substeps of `dt` (s) tell tracers of a fluid; shared with the twin.
[[nodiscard]] shader::TracerStep tracerStep(const TracerParameters& parameters, double dt, int seed,
                                            bool wrapsX, bool wrapsY);
/// Of what they drew, that is left after a frame.
[[nodiscard]] float trailKept(const TracerParameters& parameters, double frameSeconds);

struct TraceKernel;
struct TrailFade;
struct TrailShow;

/// Specks without mass that a fluid carries along, each substep by the velocities at its end, and the
/// streaks that they draw into its picture. Sums of integers: the same bits in any order.
class Tracers {
 public:
  Tracers() = default;
  /// `solid`: a byte a cell. Throws UserError(device) for more than the device holds.
  Tracers(const std::string& name, const TracerParameters& parameters, const FluidWind& wind,
          const std::vector<std::uint8_t>& solid, const shader::TracerStep& step, double frameSeconds,
          bool fast);

  /// Obstacles that have moved; a byte a cell.
  void setSolid(const std::vector<std::uint8_t>& solid);
  void beginFrame() const;
  /// A substep, once the fluid has made it.
  void advance() const;
  /// Over what is shown: the fluid's cells and their ring.
  void show(const FluidArray& shown) const;
  void carryOver(CarryOver& carry);
  [[nodiscard]] std::vector<StateArray> state() const;

 private:
  void trace(const gl::Kernel<TraceKernel>& kernel) const;

  TracerParameters parameters_;
  const FluidWind* wind_ = nullptr;
  glm::ivec2 size_{0, 0};
  gl::Vec4Array tracers_;
  gl::WordsArray solid_, trail_;
  shader::TracerStep step_{};
  float kept_ = 1;  ///< of a frame's trail
  gl::Kernel<TraceKernel> trace_;
  gl::Kernel<TrailFade> fade_;
  gl::Kernel<TrailShow> show_;
};

}  // namespace simreel::sim

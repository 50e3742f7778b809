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

/// Scene parameters of tracers: particles that make a fluid's velocity visible.
struct TracerParameters {
  int count = 2000;
  float seconds = 4;     ///< Mean lifetime in seconds. Afterwards, a tracer restarts at another position.
  float streak = 0.35F;  ///< Time in seconds in which the drawn trail fades to 1/e.
  glm::vec3 color{0.9F, 0.95F, 1.0F};  ///< Colour of the tracers, linear RGB.
  float brightness = 1;
  void describe(scene::Fields& fields);
};

/// Returns the tracers' uniform data for substeps of `dt` (seconds). The CPU twin uses it, too.
[[nodiscard]] shader::TracerStep tracerStep(const TracerParameters& parameters, double dt, int seed,
                                            bool wrapsX, bool wrapsY);
/// Returns the fraction of the trail's brightness that remains after a frame.
[[nodiscard]] float trailKept(const TracerParameters& parameters, double frameSeconds);

struct TraceKernel;
struct TrailFade;
struct TrailDisplay;

/// Massless particles that a fluid carries along, and the trails that they draw over its picture. Each
/// substep uses the fluid's velocities at the end of the substep. Trails are integer sums, so the result
/// does not depend on the order of invocations.
class Tracers {
 public:
  Tracers() = default;
  /// `solid` has one byte per cell. Throws UserError(device) if the GPU has not enough memory for the
  /// tracers.
  Tracers(const std::string& name, const TracerParameters& parameters, const FluidWind& wind,
          const std::vector<std::uint8_t>& solid, const shader::TracerStep& step, double frameSeconds,
          bool fast);

  /// Updates the obstacles after they have moved. `solid` has one byte per cell.
  void setSolid(const std::vector<std::uint8_t>& solid);
  void beginFrame() const;
  /// Advances the tracers by one substep. Call it after the fluid's substep.
  void advance() const;
  /// Draws the trails over the displayed values of the fluid's cells and their ring.
  void drawOver(const FluidArray& shown) const;
  void visitCheckpointData(CarryOver& carry);
  [[nodiscard]] std::vector<StateArray> state() const;

 private:
  void trace(const gl::Kernel<TraceKernel>& kernel) const;

  TracerParameters parameters_;
  const FluidWind* wind_ = nullptr;
  glm::ivec2 size_{0, 0};
  gl::Vec4Array tracers_;
  gl::WordsArray solid_, trail_;
  shader::TracerStep step_{};
  float kept_ = 1;  ///< Fraction of a trail's brightness that remains after a frame.
  gl::Kernel<TraceKernel> trace_;
  gl::Kernel<TrailFade> fade_;
  gl::Kernel<TrailDisplay> display_;
};

}  // namespace simreel::sim

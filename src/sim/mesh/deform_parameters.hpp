#pragma once
#include "glsl/common/cpp.hpp"
#include "scene/value/fields.hpp"

#include <vector>

namespace simreel::shader {
#include "glsl/mesh/types.glsl"
static_assert(sizeof(Displacement) == 144);
static_assert(sizeof(Presser) == 48);
static_assert(sizeof(DeformStep) == 48 + maxDisplacements * 144 + maxPressers * 48 + 16);
}  // namespace simreel::shader

namespace simreel::sim {

/// Processor that computes the deformed vertices (GPU, CPU threads or vertex shader), and the path by which
/// draw calls get them.
enum class DeformTechnique { compute, singleThread, jobs, mapped, vertexShader };

// The structs below inherit the shaders' structs, so that parameters which are passed on unchanged, and
// their defaults, are declared only once.

/// Ring waves around a centre.
struct Ripple : shader::RippleStep {
  bool on = false;
  float speed = 2.0F;             ///< phase velocity in radians per second
  float wavelength = 6.2831853F;  ///< wavelength in metres
};

/// Gerstner wave.
struct Wave : shader::WaveStep {
  float direction = 0.0F;  ///< direction in degrees from +x towards +z
  float length = 2.0F;     ///< wavelength in metres
  float steepness = 0.5F;  ///< shape of the crest: 0 is a sine, 1 a cusp
  float speed = 0.0F;      ///< speed in m/s; 0 selects the speed of deep-water waves
  float initial = 0.0F;    ///< phase in degrees at time 0
};

struct Sway : shader::SwayStep {
  bool on = false;
  float direction = 0.0F;   ///< direction in degrees from +x towards +z
  float height = 1.0F;      ///< height in metres above the base at which the lean reaches the amplitude
  float wavelength = 3.0F;  ///< wavelength of the gusts in metres
  float speed = 2.0F;       ///< phase velocity in radians per second
  /// States which values follow from the size of the mesh.
  struct Fitted {
    bool amplitude = false, base = false, height = false, wavelength = false;
  };
  Fitted fitted{};
  /// Returns these parameters with the fitted values for a mesh whose heights (m) are `low` to `high`.
  [[nodiscard]] Sway onMesh(float low, float high) const;
};

struct Footprints : shader::TrailStep {
  bool on = false;
  float rimWidth = 0.08F;  ///< width of the rim in metres
};

struct Push : shader::PushStep {
  bool on = false;
  float height = 0.0F;  ///< height in metres above the base over which the effect fades in
};

/// One entry of the list "deform"; exactly one member is active.
struct DisplacementParameters {
  Ripple ripple{};
  std::vector<Wave> waves;
  Sway sway{};
  Footprints footprints{};
  Push push{};
  void describe(scene::Fields& fields);
};

struct DeformParameters {
  std::vector<DisplacementParameters> list;
  DeformTechnique technique = DeformTechnique::compute;
  bool readback = false;
  /// Declares "deform", "technique" and "readback" in the fields of the mesh.
  void describe(scene::Fields& fields);
};

}  // namespace simreel::sim

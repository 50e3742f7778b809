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

/// Where the deformed vertices are computed, and how they get to where they are drawn.
enum class DeformTechnique { compute, singleThread, jobs, mapped, vertexShader };

// What reaches the shaders as it is, with its default, is a member of the struct that they read.

/// A ring of waves from a centre.
struct Ripple : shader::RippleStep {
  bool on = false;
  float speed = 2.0F;             ///< 1/s
  float wavelength = 6.2831853F;  ///< m
};

/// A Gerstner wave.
struct Wave : shader::WaveStep {
  float direction = 0.0F;  ///< degrees from +x towards +z
  float length = 2.0F;     ///< m
  float steepness = 0.5F;  ///< of the crest: 0 a sine, 1 a cusp
  float speed = 0.0F;      ///< m/s; 0: that of waves on deep water
  float initial = 0.0F;    ///< degrees of phase at time 0
};

struct Sway : shader::SwayStep {
  bool on = false;
  float direction = 0.0F;   ///< degrees from +x towards +z
  float height = 1.0F;      ///< m
  float wavelength = 3.0F;  ///< m
  float speed = 2.0F;       ///< 1/s
};

struct Footprints : shader::TrailStep {
  bool on = false;
  float rimWidth = 0.08F;  ///< m
};

struct Push : shader::PushStep {
  bool on = false;
  float height = 0.0F;  ///< m
};

/// One entry of "deform": exactly one of them.
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
  /// Declares "deform", "technique" and "readback" among the fields of the mesh.
  void describe(scene::Fields& fields);
};

}  // namespace simreel::sim

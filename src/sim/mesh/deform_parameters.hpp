#pragma once
#include "scene/fields.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Where the deformed vertices are computed, and how they get to where they are drawn.
enum class DeformTechnique { compute, singleThread, jobs, mapped, vertexShader };

/// A ring of waves from a centre: y = sin(t speed + 6 - k r) amplitude e^(-decay r).
struct Ripple {
  bool on = false;
  float amplitude = 0.25F;        ///< m
  float speed = 2.0F;             ///< 1/s
  float wavelength = 6.2831853F;  ///< m
  float decay = 0.0F;             ///< 1/m
  glm::vec3 centre{0, 0, 0};      ///< m
};

/// A Gerstner wave.
struct Wave {
  float direction = 0.0F;   ///< degrees from +x towards +z
  float length = 2.0F;      ///< m
  float amplitude = 0.05F;  ///< m
  float steepness = 0.5F;   ///< of the crest: 0 a sine, 1 a cusp
  float speed = 0.0F;       ///< m/s; 0: that of waves on deep water
  float phase = 0.0F;       ///< degrees
};

struct Sway {
  bool on = false;
  float direction = 0.0F;   ///< degrees from +x towards +z
  float amplitude = 0.2F;   ///< m
  float base = 0.0F;        ///< m
  float height = 1.0F;      ///< m
  float wavelength = 3.0F;  ///< m
  float speed = 2.0F;       ///< 1/s
  float lean = 0.4F;
  float gusts = 0.6F;
};

struct Footprints {
  bool on = false;
  glm::ivec2 cells{512, 512};
  float height = 0.0F;     ///< m
  float depth = 0.2F;      ///< m
  float rim = 0.25F;       ///< share of the depth
  float rimWidth = 0.08F;  ///< m
};

struct Push {
  bool on = false;
  float softness = 0.2F;  ///< m
  float base = 0.0F;      ///< m
  float height = 0.0F;    ///< m
};

/// One entry of "deform": exactly one of them.
struct DisplacementParameters {
  Ripple ripple;
  std::vector<Wave> waves;
  Sway sway;
  Footprints footprints;
  Push push;
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

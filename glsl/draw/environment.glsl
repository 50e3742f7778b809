// Environment light from a panoramic image. Compiles as GLSL and as C++. ENVIRONMENT is the number of cells on a side
// of the finest map. environmentTexel(i) returns texel i of the environment buffer. The buffer starts with the
// spherical harmonics of irradiance / pi as a function of the normal: nine coefficients, up to degree two, that include
// all constant factors (Ramamoorthi and Hanrahan 2001). Octahedral maps follow (Engelhardt and Dachsbacher 2008). The
// up direction is in the middle of a map, and a border of one cell continues the map. Level 0 holds the radiance that
// the camera shows. Levels 1 to 4 hold the light reflected by surfaces of roughness 1/4, 1/2, 3/4 and 1.
#ifndef DRAW_ENVIRONMENT
#define DRAW_ENVIRONMENT
#include "draw/arithmetic.glsl"

const int environmentTerms = 9, environmentLevels = 5;

FUNCTION int environmentSide(int level) {
  return level == 0 ? ENVIRONMENT : 256 >> level;
}

FUNCTION int environmentStart(int level) {
  int start = environmentTerms;
  for (int i = 0; i < level; ++i) start += (environmentSide(i) + 2) * (environmentSide(i) + 2);
  return start;
}

// Returns the position of a direction on an octahedral map, -1 to 1 in both axes.
FUNCTION vec2 octahedral(vec3 direction) {
  ROUNDED float sum = abs(direction.x) + abs(direction.y) + abs(direction.z);
  float per = inverse(sum);
  ROUNDED vec2 at = vec2(direction.x, direction.z) * per;
  ROUNDED vec2 folded = vec2(1.0f - abs(at.y), 1.0f - abs(at.x));
  if (direction.y < 0.0f) at = vec2(at.x < 0.0f ? -folded.x : folded.x, at.y < 0.0f ? -folded.y : folded.y);
  return at;
}

FUNCTION vec3 environmentAt(vec3 direction, int level) {
  int side = environmentSide(level), row = side + 2, start = environmentStart(level);
  ROUNDED vec2 at = (octahedral(direction) * 0.5f + 0.5f) * float(side) + 0.5f;
  vec2 low = clamp(floor(at), vec2(0.0f), vec2(float(side)));
  ROUNDED vec2 share = at - low;
  int first = start + int(low.y) * row + int(low.x);
  vec3 above = blend(vec3(environmentTexel(first)), vec3(environmentTexel(first + 1)), share.x);
  vec3 below = blend(vec3(environmentTexel(first + row)), vec3(environmentTexel(first + row + 1)), share.x);
  return blend(above, below, share.y);
}

// Returns the radiance that a surface of the given roughness reflects. `direction` is the mirror direction of the view.
FUNCTION vec3 environmentMirrored(vec3 direction, float roughness) {
  ROUNDED float place = clamp(roughness, 0.0f, 1.0f) * 4.0f;
  int level = min(int(place), environmentLevels - 2);
  ROUNDED float share = place - float(level);
  return blend(environmentAt(direction, level), environmentAt(direction, level + 1), share);
}

// Returns irradiance / pi on a surface with normal `n`.
FUNCTION vec3 environmentAmbient(vec3 n) {
  ROUNDED vec3 sum = vec3(environmentTexel(0)) + vec3(environmentTexel(1)) * n.x + vec3(environmentTexel(2)) * n.y +
                     vec3(environmentTexel(3)) * n.z + vec3(environmentTexel(4)) * (n.x * n.y) + vec3(environmentTexel(5)) * (n.y * n.z) +
                     vec3(environmentTexel(6)) * (n.z * n.x) + vec3(environmentTexel(7)) * (n.x * n.x - n.z * n.z) +
                     vec3(environmentTexel(8)) * (3.0f * n.y * n.y - 1.0f);
  return max(sum, 0.0f);
}
#endif

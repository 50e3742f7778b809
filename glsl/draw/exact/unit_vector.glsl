// Unit vectors packed in 32 bits with octahedral encoding, 65,535 steps per axis (Cigolle et al., "A survey of
// efficient representations for independent unit vectors", JCGT 3(2), 2014). Compiles as GLSL and as C++.
#ifndef EXACT_UNIT_VECTOR
#define EXACT_UNIT_VECTOR
#include "common/exact.glsl"

FUNCTION uint packedUnit(vec3 n) {
  precise float length_ = abs(n.x) + abs(n.y) + abs(n.z);
  float perLength = exactReciprocal(max(length_, 1e-30f));
  precise float u = n.x * perLength;
  precise float v = n.y * perLength;
  precise float foldedU = (1.0f - abs(v)) * (u < 0.0f ? -1.0f : 1.0f);
  precise float foldedV = (1.0f - abs(u)) * (v < 0.0f ? -1.0f : 1.0f);
  if (n.z < 0.0f) {
    u = foldedU;
    v = foldedV;
  }
  precise float x = clamp(u, -1.0f, 1.0f) * 32767.0f + 32767.5f;
  precise float y = clamp(v, -1.0f, 1.0f) * 32767.0f + 32767.5f;
  return uint(int(floor(x))) | uint(int(floor(y))) << 16;
}

// Returns the direction. Its length is between 1/sqrt(3) and 1.
FUNCTION vec3 unpackedDirection(uint word) {
  precise float u = float(int(word & 0xffffu) - 32767) * 3.0518509e-5f;
  precise float v = float(int(word >> 16) - 32767) * 3.0518509e-5f;
  precise float z = 1.0f - abs(u) - abs(v);
  precise float fold = max(-z, 0.0f);
  precise float x = u < 0.0f ? u + fold : u - fold;
  precise float y = v < 0.0f ? v + fold : v - fold;
  return vec3(x, y, z);
}

FUNCTION vec3 unpackedUnit(uint word) {
  vec3 direction = unpackedDirection(word);
  precise vec3 n = direction * exactInverseSqrt(exactDot(direction, direction));
  return n;
}
#endif

// Random numbers as integer hashes of position and time, without stored state (PCG family; Jarzynski and Olano, "Hash
// Functions for GPU Rendering", JCGT 9(3), 2020). Compiles as GLSL and as C++.

// Hashes three words to three well-mixed words.
FUNCTION uvec3 hash3(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v = v ^ (v >> 16u);
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}

// Converts the upper 24 bits of a word to a number in [-1, 1), without rounding.
FUNCTION float signedUnit(uint bits) {
  precise float u = float(int(bits >> 8u) - 8388608) * 1.1920929e-7f;
  return u;
}
FUNCTION vec3 signedUnits(uvec3 bits) {
  return vec3(signedUnit(bits.x), signedUnit(bits.y), signedUnit(bits.z));
}

// Test inputs for functions. Compiles as GLSL and as C++ after common/hash.glsl.

FUNCTION uvec3 diced(int i, int k) {
  return hash3(uvec3(uint(i), uint(k), 77u));
}

// Returns one of the five numbers -1, -0.5, 0, 0.5 and 1, so that equal values are common. One result in four is any
// number between -1 and 1.
FUNCTION float someNumber(uint bits) {
  precise float few = float(int((bits >> 4u) % 5u) - 2) * 0.5f;
  return (bits & 3u) == 0u ? signedUnit(bits) : few;
}

FUNCTION vec3 somePlace(int i, int k) {
  uvec3 bits = diced(i, k);
  return vec3(someNumber(bits.x), someNumber(bits.y), someNumber(bits.z));
}

// Returns an integer from 0 to most - 1.
FUNCTION int someOf(int i, int k, int maximum) {
  return int((diced(i, k).x >> 8u) % uint(maximum));
}

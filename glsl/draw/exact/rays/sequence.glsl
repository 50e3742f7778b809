// Sample points in the unit cube for the light of a pixel: three dimensions of Sobol's sequence (direction numbers of
// Joe and Kuo, 2008). The order of the points and each coordinate are Owen-scrambled (1995) with a hash in which a bit
// depends only on higher bits (Laine and Karras, "Stratified Sampling for Stochastic Transparency", 2011). Only integer
// arithmetic is used. Compiles as GLSL and as C++, after common/hash.glsl.
#ifndef EXACT_RAY_SEQUENCE
#define EXACT_RAY_SEQUENCE

FUNCTION uint reversedBits(uint x) {
  uint r = (x >> 16) | (x << 16);
  r = ((r & 0xff00ff00u) >> 8) | ((r & 0x00ff00ffu) << 8);
  r = ((r & 0xf0f0f0f0u) >> 4) | ((r & 0x0f0f0f0fu) << 4);
  r = ((r & 0xccccccccu) >> 2) | ((r & 0x33333333u) << 2);
  r = ((r & 0xaaaaaaaau) >> 1) | ((r & 0x55555555u) << 1);
  return r;
}

// Hash in which each bit of the result depends only on the same and the lower bits of x.
FUNCTION uint mixedUpwards(uint x, uint seed) {
  uint r = x + seed;
  r ^= r * 0x5a3e9c66u;
  r += (seed >> 16) | 1u;
  r ^= r * 0xb6d2a8d2u;
  r ^= r * 0x2c9277b4u;
  return r;
}

// Owen scrambling: a hash in which each bit of the result depends only on the same and the higher bits.
FUNCTION uint owenScrambled(uint x, uint seed) {
  return reversedBits(mixedUpwards(reversedBits(x), seed));
}

const int sequenceBits = 10;  // number of bits in a sample index

// These functions return the second and third dimension of the Sobol sequence. If bit b of the index i is set, the
// result includes direction number b.
FUNCTION uint sobolSecond(uint i) {
  uint x = 0u, v = 0x80000000u;
  for (int b = 0; b < sequenceBits; ++b) {
    x ^= (i >> uint(b) & 1u) * v;
    v ^= v >> 1;
  }
  return x;
}
FUNCTION uint sobolThird(uint i) {
  uint x = 0u, v = 0x80000000u, next = 0xc0000000u;
  for (int b = 0; b < sequenceBits; ++b) {
    x ^= (i >> uint(b) & 1u) * v;
    uint after = next ^ v ^ (v >> 2);
    v = next;
    next = after;
  }
  return x;
}

FUNCTION float unitFraction(uint bits) {
  precise float u = float(int(bits >> 8)) * 5.9604645e-8f;
  return u;
}

// Returns sample i of set `which` for a pixel with the given seed. `mask` is a bit mask into which all sample indices
// fit.
FUNCTION vec3 samplePoint(uint i, uint mask, uint seed, uint which) {
  uvec3 seeds = hash3(uvec3(seed, which, 0x9e3779b9u)), more = hash3(uvec3(which, seed, 0x85ebca6bu));
  uint at = owenScrambled(i, seeds.x) & mask;
  uint x = owenScrambled(reversedBits(at), seeds.y);
  uint y = owenScrambled(sobolSecond(at), seeds.z);
  uint z = owenScrambled(sobolThird(at), more.x);
  return vec3(unitFraction(x), unitFraction(y), unitFraction(z));
}
#endif

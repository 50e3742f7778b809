// Returns numbers of all magnitudes, including the limits of each function's domain.
FUNCTION float anyNumber(int i, int k) {
  uvec3 bits = diced(i, k);
  // a number with a magnitude between 2^-40 and 2^40
  float some = intBitsToFloat(int((bits.x & 0x807fffffu) | ((87u + bits.y % 80u) << 23u)));
  return (bits.z & 7u) == 0u ? someNumber(bits.y) : some;
}

FUNCTION vec4 asked(int i) {
  float x = anyNumber(i, 0), y = anyNumber(i, 1);
  precise float turn = 16.0f * signedUnit(diced(i, 2).x);
  precise float grown = 90.0f * signedUnit(diced(i, 3).x);
  float size = max(abs(x), 1e-30f);
  int what = i % 3;
  if (what == 0) return vec4(exactSin(turn), exactCos(turn), exactExp(grown), exactLog(size));
  if (what == 1) return vec4(exactSqrt(abs(x)), exactInverseSqrt(size), exactReciprocal(size), exactPow(abs(someNumber(diced(i, 4).x)), abs(turn)));
  vec3 a = somePlace(i, 5), b = somePlace(i, 6);
  precise vec3 sum = exactCross(a, b) + exactMix(a, b, 0.5f + 0.5f * someNumber(diced(i, 7).x));
  precise float small = 1e-20f * y;
  precise float both = exactDot(vec4(a, x), vec4(b, y)) + exactFlush(small) * 1e10f;
  return vec4(sum, both);
}

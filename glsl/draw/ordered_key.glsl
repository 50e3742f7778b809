// Keys that order like the floats they stand for, so that integer atomics can find the least and the largest.
uint orderedKey(float x) {
  uint bits = floatBitsToUint(x);
  return bits ^ ((bits >> 31) != 0u ? 0xffffffffu : 0x80000000u);
}
float fromOrderedKey(uint key) {
  return uintBitsToFloat(key ^ ((key >> 31) != 0u ? 0x80000000u : 0xffffffffu));
}

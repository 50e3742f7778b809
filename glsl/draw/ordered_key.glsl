// Maps floats to unsigned keys with the same order, so that integer atomics can compute the min and max of floats.
uint orderedKey(float x) {
  uint bits = floatBitsToUint(x);
  return bits ^ ((bits >> 31) != 0u ? 0xffffffffu : 0x80000000u);
}
float fromOrderedKey(uint key) {
  return uintBitsToFloat(key ^ ((key >> 31) != 0u ? 0x80000000u : 0xffffffffu));
}

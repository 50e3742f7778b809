// Reads the value of a uniform once, at the start of the kernel. Inside loops, software drivers read uniforms lane by
// lane, with about 25 instructions for each number. Copying the uniform to a variable does not help, because compilers
// replace the variable by the uniform. Therefore, once() copies through a bit cast, or through a clamp that never takes
// effect. Usage, for global variables: T name_ = once(name).
#ifndef COMMON_ONCE
#define COMMON_ONCE
float once(float x) {
  return intBitsToFloat(floatBitsToInt(x));
}
vec2 once(vec2 x) {
  return intBitsToFloat(floatBitsToInt(x));
}
vec3 once(vec3 x) {
  return intBitsToFloat(floatBitsToInt(x));
}
vec4 once(vec4 x) {
  return intBitsToFloat(floatBitsToInt(x));
}
mat4 once(mat4 x) {
  return mat4(once(x[0]), once(x[1]), once(x[2]), once(x[3]));
}
int once(int x) {
  return max(x, -0x7fffffff);
}
ivec2 once(ivec2 x) {
  return max(x, ivec2(-0x7fffffff));
}
ivec4 once(ivec4 x) {
  return max(x, ivec4(-0x7fffffff));
}
uint once(uint x) {
  return min(x, 0xfffffffeu);
}
bool once(bool x) {
  return once(int(x)) != 0;
}
#endif

// simreel's own file for shaders that include that of Unity's core package: what compute shaders use of it.
#ifndef SIMREEL_CORE_COMMON
#define SIMREEL_CORE_COMMON
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Macros.hlsl"
float Sq(float x) {
  return x * x;
}
float Remap01(float x, float scale, float offset) {
  return saturate(x * scale - offset);
}
float3 SafeNormalize(float3 v) {
  return v * rsqrt(max(FLT_MIN, dot(v, v)));
}
float Min3(float a, float b, float c) {
  return min(min(a, b), c);
}
float Max3(float a, float b, float c) {
  return max(max(a, b), c);
}
#endif

// simreel's replacement for the file of this name from Unity's core package, for shaders that include it. Contains the
// functions that compute shaders use.
#ifndef SIMREEL_CORE_COMMON
#define SIMREEL_CORE_COMMON
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Macros.hlsl"
#define real float
#define real2 float2
#define real3 float3
#define real4 float4
#define real2x2 float2x2
#define real3x3 float3x3
#define real4x4 float4x4
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

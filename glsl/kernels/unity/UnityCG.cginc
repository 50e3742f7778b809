// simreel's replacement for the file of this name from Unity, for shaders that include it. Contains the functions that
// compute shaders use.
#ifndef SIMREEL_UNITY_CG
#define SIMREEL_UNITY_CG
#include "UnityShaderVariables.cginc"
#define UNITY_PI 3.14159265359
#define UNITY_TWO_PI 6.28318530718
#define UNITY_FOUR_PI 12.56637061436
#define UNITY_INV_PI 0.31830988618
#define UNITY_INV_TWO_PI 0.15915494309
#define UNITY_HALF_PI 1.57079632679
#define UNITY_INV_HALF_PI 0.636619772367
#define UnityStereoScreenSpaceUVAdjust(uv, st) (uv)
#define TransformStereoScreenSpaceTex(uv, w) (uv)
#define UNITY_SAMPLE_DEPTH(value) (value).r
#define TRANSFORM_TEX(uv, name) ((uv).xy * name##_ST.xy + name##_ST.zw)

float Luminance(float3 rgb) {
  return dot(rgb, float3(0.2126, 0.7152, 0.0722));
}
// Converts an sRGB value to linear light with the transfer function of sRGB.
float GammaToLinearSpaceExact(float value) {
  return value <= 0.04045 ? value / 12.92 : pow((value + 0.055) / 1.055, 2.4);
}
float LinearToGammaSpaceExact(float value) {
  return value <= 0.0031308 ? value * 12.92 : 1.055 * pow(value, 1.0 / 2.4) - 0.055;
}
float3 GammaToLinearSpace(float3 rgb) {
  return float3(GammaToLinearSpaceExact(rgb.r), GammaToLinearSpaceExact(rgb.g), GammaToLinearSpaceExact(rgb.b));
}
float3 LinearToGammaSpace(float3 rgb) {
  rgb = max(rgb, 0);
  return float3(LinearToGammaSpaceExact(rgb.r), LinearToGammaSpaceExact(rgb.g), LinearToGammaSpaceExact(rgb.b));
}
float3 UnityObjectToWorldDir(float3 direction) {
  return normalize(mul((float3x3)unity_ObjectToWorld, direction));
}
float4 UnityWorldToClipPos(float3 position) {
  return mul(unity_MatrixVP, float4(position, 1));
}
float4 UnityObjectToClipPos(float3 position) {
  return mul(unity_MatrixVP, mul(unity_ObjectToWorld, float4(position, 1)));
}
float LinearEyeDepth(float z) {
  return 1.0 / (_ZBufferParams.z * z + _ZBufferParams.w);
}
float Linear01Depth(float z) {
  return 1.0 / (_ZBufferParams.x * z + _ZBufferParams.y);
}
float4 EncodeFloatRGBA(float value) {
  float4 parts = frac(float4(1.0, 255.0, 65025.0, 16581375.0) * value);
  return parts - parts.yzww * (1.0 / 255.0);
}
float DecodeFloatRGBA(float4 parts) {
  return dot(parts, float4(1.0, 1.0 / 255.0, 1.0 / 65025.0, 1.0 / 16581375.0));
}
#endif

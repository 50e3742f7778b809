// simreel's replacement for the file of this name from Unity, for shaders that include it: time, camera and screen as
// constants that the scene sets.
#ifndef SIMREEL_UNITY_SHADER_VARIABLES
#define SIMREEL_UNITY_SHADER_VARIABLES
#include "HLSLSupport.cginc"
cbuffer UnityPerFrame {
  float4 _Time;            // t / 20, t, 2 t, 3 t, where t is the time in seconds
  float4 _SinTime;         // sin of t / 8, t / 4, t / 2, t
  float4 _CosTime;
  float4 unity_DeltaTime;  // dt, 1 / dt, smoothed dt, 1 / smoothed dt
};
cbuffer UnityPerCamera {
  float3 _WorldSpaceCameraPos;
  float4 _ProjectionParams;  // 1, near plane, far plane, 1 / far plane
  float4 _ScreenParams;      // width, height, 1 + 1 / width, 1 + 1 / height
  float4 _ZBufferParams;
  float4 unity_OrthoParams;
  float4x4 unity_MatrixV;
  float4x4 unity_MatrixVP;
  float4x4 unity_MatrixInvV;
  float4x4 unity_MatrixInvVP;
  float4x4 glstate_matrix_projection;
  float4x4 unity_CameraProjection;
  float4x4 unity_CameraInvProjection;
  float4x4 unity_WorldToCamera;
  float4x4 unity_CameraToWorld;
};
cbuffer UnityPerDraw {
  float4x4 unity_ObjectToWorld;
  float4x4 unity_WorldToObject;
};
cbuffer UnityLighting {
  float4 _WorldSpaceLightPos0;
  float4 _LightColor0;
};
#define UNITY_MATRIX_V unity_MatrixV
#define UNITY_MATRIX_VP unity_MatrixVP
#define UNITY_MATRIX_P glstate_matrix_projection
#define UNITY_MATRIX_I_V unity_MatrixInvV
#define UNITY_MATRIX_I_VP unity_MatrixInvVP
#define UNITY_MATRIX_MV mul(unity_MatrixV, unity_ObjectToWorld)
#define UNITY_MATRIX_MVP mul(unity_MatrixVP, unity_ObjectToWorld)
#define UNITY_MATRIX_M unity_ObjectToWorld
#endif

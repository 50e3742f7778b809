// simreel's replacement for the file of this name from Unity's core package, for shaders that include it.
#ifndef SIMREEL_CORE_MACROS
#define SIMREEL_CORE_MACROS
#define PI 3.14159265358979323846
#define TWO_PI 6.28318530717958647693
#define FOUR_PI 12.5663706143591729538
#define INV_PI 0.31830988618379067154
#define INV_TWO_PI 0.15915494309189533577
#define HALF_PI 1.57079632679489661923
#define LOG2_E 1.44269504088896340736
#define FLT_EPS 5.960464478e-8
#define FLT_MIN 1.175494351e-38
#define FLT_MAX 3.402823466e+38
#define MERGE_NAME(a, b) a##b
#define real float
#define real2 float2
#define real3 float3
#define real4 float4
#define REAL_MIN FLT_MIN
#define REAL_MAX FLT_MAX
#endif

// simreel's replacement for the file of this name from Unity, for shaders that include it.
#ifndef SIMREEL_HLSL_SUPPORT
#define SIMREEL_HLSL_SUPPORT
#define UNITY_DECLARE_TEX2D(name) Texture2D name; SamplerState sampler##name
#define UNITY_DECLARE_TEX2D_NOSAMPLER(name) Texture2D name
#define UNITY_DECLARE_TEX3D(name) Texture3D name; SamplerState sampler##name
#define UNITY_DECLARE_TEX2DARRAY(name) Texture2DArray name; SamplerState sampler##name
#define UNITY_DECLARE_TEX2D_FLOAT(name) UNITY_DECLARE_TEX2D(name)
#define UNITY_DECLARE_TEX2D_HALF(name) UNITY_DECLARE_TEX2D(name)
#define UNITY_DECLARE_TEX3D_FLOAT(name) UNITY_DECLARE_TEX3D(name)
#define UNITY_SAMPLE_TEX2D(name, at) name.SampleLevel(sampler##name, at, 0)
#define UNITY_SAMPLE_TEX2D_LOD(name, at, lod) name.SampleLevel(sampler##name, at, lod)
#define UNITY_SAMPLE_TEX3D_LOD(name, at, lod) name.SampleLevel(sampler##name, at, lod)
#define UNITY_SAMPLE_TEX2DARRAY_LOD(name, at, lod) name.SampleLevel(sampler##name, at, lod)
#endif

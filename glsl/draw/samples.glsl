// Declares a texture with SAMPLES samples per texel, 1 or more. SAMPLE(s) is the last argument of texelFetch for sample
// s; with one sample per texel it is the mip level 0.
#if SAMPLES > 1
#define SAMPLED sampler2DMS
#define SAMPLE(s) (s)
#else
#define SAMPLED sampler2D
#define SAMPLE(s) 0
#endif

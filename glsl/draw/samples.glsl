// A texture of SAMPLES samples, 1 or more; number s of them is the last argument of texelFetch: a level where there
// are none.
#if SAMPLES > 1
#define SAMPLED sampler2DMS
#define SAMPLE(s) (s)
#else
#define SAMPLED sampler2D
#define SAMPLE(s) 0
#endif

// Triangle corners and vertex words of the ray scene (written by gather.comp).
#ifndef EXACT_RAY_SOLID_WORDS
#define EXACT_RAY_SOLID_WORDS
#include "draw/exact/rays/bindings.glsl"
layout(binding = solidCornerUnit) uniform usamplerBuffer corners;
layout(binding = solidWordUnit) uniform usamplerBuffer vertexWords;
#endif

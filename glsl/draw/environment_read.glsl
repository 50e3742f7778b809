// The texels of environment.glsl.
#include "draw/bindings.glsl"
layout(binding = environmentUnit) uniform samplerBuffer environment;
#define environmentTexel(i) texelFetch(environment, i)

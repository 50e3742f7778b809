// Defines environmentTexel(i) of environment.glsl as a texture fetch.
#include "draw/bindings.glsl"
layout(binding = environmentUnit) uniform samplerBuffer environment;
#define environmentTexel(i) texelFetch(environment, i)

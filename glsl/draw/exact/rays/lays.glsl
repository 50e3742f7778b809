// Texture positions of the ray scene's vertices.
#ifndef EXACT_RAY_LAYS
#define EXACT_RAY_LAYS
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/surface/map_read.glsl"
layout(binding = rayLayUnit) uniform samplerBuffer lays;  // texture position of each vertex: uv, or position in the
                                                          // surface's object space (m)
#endif

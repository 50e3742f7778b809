// Where maps and skins are laid on what rays meet.
#ifndef EXACT_RAY_LAYS
#define EXACT_RAY_LAYS
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/surface/map_read.glsl"
layout(binding = rayLayUnit) uniform samplerBuffer lays;  // of vertices: uv, or the place in the surface's own space (m)
#endif

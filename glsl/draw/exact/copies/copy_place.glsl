// Projection of scene points to the picture, for copies.
#include "draw/exact/view_block.glsl"
#include "draw/exact/corner_place.glsl"

// Projects scene points of mesh copies to the picture.
#include "draw/exact/view_block.glsl"
#include "draw/exact/corner_place.glsl"

// Where a place of the scene lies on the picture.
#include "draw/exact/view_block.glsl"
#include "draw/exact/corner_place.glsl"

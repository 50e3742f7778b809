// Reads what a pixel of a view shows through lens points of its own (lens_shift.glsl).
layout(r32f, binding = nearnessImage) readonly restrict uniform image2D nearness;
uniform int number;  // index of the view
uniform vec3 lens;   // x and y: shift of a point at infinity, and its decrease per nearness (pixels per radius of the
                     // lens); z: side of the square around the view's point (radii)

float nearnessAt(ivec2 at) {
  return imageLoad(nearness, at).x;
}
#include "draw/exact/screen/lens_shift.glsl"

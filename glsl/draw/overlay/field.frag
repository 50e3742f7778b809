// Draws a field of cells as a fragment shader (field_shading.glsl).
#include "draw/arithmetic.glsl"
#include "draw/overlay/field_inputs.glsl"
#include "draw/overlay/field_view.glsl"
#include "draw/overlay/field_values.glsl"
#include "draw/screen/film.glsl"
#include "draw/overlay/field_shading.glsl"
uniform vec2 picture;    // picture size in pixels
uniform bool topFirst;   // true if row 0 of the target is the picture's top row
layout(location = 0) out vec4 pixel;

void main() {
  pixel = fieldPixel(ivec2(gl_FragCoord.x, topFirst ? gl_FragCoord.y : picture.y - gl_FragCoord.y));
}

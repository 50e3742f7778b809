// Draws text over the finished picture, on a dark panel. A byte per pixel of the text box holds the fraction that
// letters cover. One invocation draws one pixel.
#define EXACT_PICTURE
#include "draw/arithmetic.glsl"
#include "draw/bindings.glsl"
#include "draw/overlay/pixel.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = boxUnit) uniform usamplerBuffer shares;
layout(rgba8, binding = targetImage) uniform restrict image2D target;
uniform ivec4 panel, box;  // bounds of the panel and of the text in pixels: left, top, right, bottom
uniform vec3 color;        // sRGB-encoded text colour
uniform float opacity;
uniform float backdrop;

void main() {
  ivec2 at = panel.xy + ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= panel.z || at.y >= panel.w) return;
  vec4 bytes = bytesOf(imageLoad(target, at));
  float shade = backdrop * opacity;
  bytes = laidOver(bytes, vec4(vec3(0.02f * shade), shade));
  if (at.x >= box.x && at.y >= box.y && at.x < box.z && at.y < box.w) {
    int i = (at.y - box.y) * (box.z - box.x) + at.x - box.x;
    ROUNDED float share = float(texelFetch(shares, i).x) * 0.00392156863f * opacity;
    ROUNDED vec3 laid = color * share;
    bytes = laidOver(bytes, vec4(laid, share));
  }
  imageStore(target, at, storedBytes(bytes));
}

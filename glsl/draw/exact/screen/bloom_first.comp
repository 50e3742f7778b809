// Writes the light above the bloom threshold at half the picture's size, as draw/screen/bloom_first.glsl does. One
// invocation writes one texel.
#define EXACT_PICTURE
#include "common/exact.glsl"
#include "draw/frame_block.glsl"
#include "draw/exact/screen/edge_light.glsl"
#include "draw/exact/screen/light_read.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
LIGHT_PICTURE(sceneUnit, lightImage, scene);
layout(rgba32f, binding = sumImage) writeonly restrict uniform image2D half_;
uniform ivec2 size;  // size of the scene in pixels
uniform float threshold;

vec3 above(ivec2 at) {
  vec3 light = min(evenedLight(LIGHT_AT(scene, min(at, size - 1)), frame.exposure).rgb, 6e4f);
  float brightest = max(light.r, max(light.g, light.b));
  precise float over = brightest - threshold;
  precise vec3 rest = light * (max(over, 0.0f) * exactReciprocal(max(brightest, 1e-6f)));
  return rest;
}

void main() {
  ivec2 at = 2 * ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= size.x || at.y >= size.y) return;
  precise vec3 sum = above(at) + above(at + ivec2(1, 0)) + above(at + ivec2(0, 1)) + above(at + ivec2(1, 1));
  precise vec3 mean = 0.25f * sum;
  imageStore(half_, at / 2, vec4(mean, 1.0f));
}

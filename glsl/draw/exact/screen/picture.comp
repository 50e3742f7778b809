// Writes the finished picture as bytes: light over the sky, after lens and film. TRANSPARENT: without the sky. BLOOM:
// adds the bloom light. LINEAR: writes the light before lens and film instead. DEEP: writes the film's values without
// rounding to bytes. One invocation writes ROWS vertically adjacent pixels.
#define EXACT_PICTURE
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/ground_plane.glsl"
#include "draw/exact/screen/edge_light.glsl"
#include "draw/exact/screen/light_read.glsl"
#include "draw/sky.glsl"
#include "draw/screen/film.glsl"
#include "draw/screen/lens.glsl"
#include "draw/screen/cover.glsl"
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
LIGHT_PICTURE(sceneUnit, lightImage, sums);
#if defined LINEAR || defined DEEP
layout(rgba32f, binding = pictureImage) writeonly restrict uniform image2D picture;
#else
layout(rgba8, binding = pictureImage) writeonly restrict uniform image2D picture;
#endif
uniform vec2 perSize;  // 2 / size of the picture in pixels
vec2 perSize_ = once(perSize);
#ifdef TRANSPARENT
uniform float white;  // light of a white surface; unlimited in a picture without blended layers
float white_ = once(white);
#endif
#ifdef BLOOM
#include "draw/exact/screen/bloom_read.glsl"
uniform float bloomStrength;
float bloomStrength_ = once(bloomStrength);
#endif

// Rounds a fraction of white to a multiple of 1/255, a value that every driver stores as the same byte.
float asByte(float x) {
  precise float scaled = clamp(x, 0.0f, 1.0f) * 255.0f + 0.5f;
  precise float byte_ = floor(scaled) * 0.0039215687f;
  return byte_;
}

void finish(ivec2 at) {
  vec4 drawn = min(evenedLight(LIGHT_AT(sums, at), frame.exposure), 6e4f);
  precise vec2 place = vec2(at) + 0.5f;
#ifdef TRANSPARENT
  precise vec3 light = drawn.rgb;
#else
  vec3 direction = unitOf(directionOf(rayThrough(place)));
  precise vec3 light = drawn.rgb + (1.0f - drawn.a) * skyInDirection(direction);
#endif
#ifdef BLOOM
  light = light + bloomStrength_ * scatteredAt(at);
#endif
  precise vec2 aside = place * perSize_ - 1.0f;
#ifdef TRANSPARENT
#ifdef LINEAR
  imageStore(picture, at, vec4(light, drawn.a));
#else
  precise vec3 added = light - drawn.rgb + lightBeyondCover(drawn.rgb, drawn.a, white_);
  vec3 shown = encoded(filmed(throughLens(added, aside)));
  float cover = coverOf(drawn.a, shown);
  vec3 surface = encoded(filmed(lightOfCover(throughLens(light, aside), cover)));
  vec3 own = colorOfCover(surface, drawn.a, shown, cover);
#ifdef DEEP
  imageStore(picture, at, cover < 1e-4f ? vec4(0.0f) : vec4(own, cover));
  return;
#endif
  precise vec3 color = own + dither(at);
  color = cover < 1e-4f ? vec3(0.0f) : color;
  imageStore(picture, at, vec4(asByte(color.r), asByte(color.g), asByte(color.b), asByte(cover)));
#endif
#elif defined LINEAR
  imageStore(picture, at, vec4(light, 1.0f));
#elif defined DEEP
  imageStore(picture, at, vec4(encoded(filmed(throughLens(light, aside))), 1.0f));
#else
  precise vec3 color = encoded(filmed(throughLens(light, aside))) + dither(at);
  imageStore(picture, at, vec4(asByte(color.r), asByte(color.g), asByte(color.b), 1.0f));
#endif
}

void main() {
  ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, ROWS);
  for (int row = 0; row < ROWS; ++row) {
    ivec2 at = first + ivec2(0, row);
    if (at.x < view.size.x && at.y < view.size.y) finish(at);
  }
}

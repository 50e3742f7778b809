// Holes of the triangle that is being rasterized, at samples where the material's opacity is below a limit (CUTOUT).
// The opacity is read at each sample, filtered over the footprint of the pixel. Define: GRID.
#include "draw/exact/weights.glsl"
#include "draw/exact/surface/vertex_uv.glsl"
#include "draw/exact/surface/map_read.glsl"
uniform ivec4 colorMap;
ivec4 colorMap_ = once(colorMap);
uniform vec2 textureScale;
vec2 textureScale_ = once(textureScale);
uniform vec2 opacityLimit;  // x: opacity of the whole material; y: min opacity of a visible sample
vec2 opacityLimit_ = once(opacityLimit);
vec3 cutA = vec3(0), cutB = vec3(0), cutC = vec3(0);  // corners of the triangle, projected to the picture
vec2 cutUvA = vec2(0), cutUvB = vec2(0), cutUvC = vec2(0);

void cutTriangle(ivec3 corners, vec3 a, vec3 b, vec3 c) {
  cutA = a;
  cutB = b;
  cutC = c;
  cutUvA = uvOf(corners.x);
  cutUvB = uvOf(corners.y);
  cutUvC = uvOf(corners.z);
}

vec2 cutUv(vec2 place) {
  vec3 w = ofSumOne(weightsAround(cutA, cutB, cutC, place));
  precise vec2 uv = (w.x * cutUvA + w.y * cutUvB + w.z * cutUvC) * textureScale_;
  return uv;
}

// Returns the samples of the mask that are not in a hole.
int uncut(ivec2 pixel, int mask) {
  precise vec2 middle = vec2(pixel) + 0.5f;
  precise vec2 right = middle + vec2(1, 0);
  precise vec2 above = middle + vec2(0, -1);
  vec2 at = cutUv(middle);
  precise vec2 across = cutUv(right) - at;
  precise vec2 up = cutUv(above) - at;
  Footprint print = footprintOf(Seen(at, across, up), mapShape(colorMap_));
  int there = 0;
  for (int s = 0; s < SAMPLES; ++s) {
    if ((mask >> s & 1) == 0) continue;
    precise vec2 place = vec2(pixel * 16 + samplePlace(s)) * 0.0625f;
    precise float opacity = mapWithin(cutUv(place), print, colorMap_).a * opacityLimit_.x;
    there |= opacity >= opacityLimit_.y ? 1 << s : 0;
  }
  return there;
}

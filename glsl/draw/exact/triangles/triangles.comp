// Rasterizes the small triangles of one surface, one per invocation. Appends larger triangles to a list: medium-sized
// ones from its end (medium.comp), large ones from its start (large.comp). BINS: unclipped triangles are listed by tile
// (bins.glsl) instead of rasterized; in shadow maps, very small ones are rasterized anyway. SAMPLES, PASS, SUN_MAP,
// LAMP_MAP: as in draw/exact/visible_sample.glsl. COUNTED: the GPU has written the number of triangles to the draw
// arguments. CUTOUT, LAYER: as in draw/exact/triangles/raster_triangle.glsl. BALLOT: as in draw/exact/list_place.glsl.
#include "draw/exact/triangles/raster.glsl"
#include "draw/exact/triangles/fill_box.glsl"
#ifdef BINS
#define MAKES_BINS
#include "draw/exact/triangles/bins.glsl"
#endif
layout(local_size_x = 64) in;
layout(std430, binding = largeBinding) restrict buffer LargeBlock { uint large[]; };
layout(std430, binding = counterBinding) restrict buffer CounterBlock { uint counters[]; };
#ifdef FACES
int draw_ = face_;
#else
uniform int draw_;         // index of the current surface among all drawn surfaces
#endif
uniform int draws;
// Max side (pixels) of the bounding box of a medium-sized triangle. If this is not above the limit of small triangles,
// no triangle is medium-sized.
uniform int mediumPixels;
#include "draw/exact/list_place.glsl"
#if defined BINS && (defined LAMP_MAP || defined SUN_MAP)
// Shadow maps have one sample per texel and no ids, so for a small triangle a few atomics cost less than all samples of
// a tile.
const int smallerBy = 4;
#else
const int smallerBy = 1;
#endif

void drawOrList(int number) {
#ifdef LAMP_MAP
  number = triangleAt(number);
#endif
  seeSides(number);
  ivec3 corners = cornersOf(number);
  uvec4 a = vertexOf(corners.x), b = vertexOf(corners.y), c = vertexOf(corners.z);
  if (a.w == lostVertex || b.w == lostVertex || c.w == lostVertex) return;
  vec2 size = vec2(PICTURE_SIZE);
#ifndef SUN_MAP
  float nearest = view.near;
#endif
  vec3 pa = drawnPlace(a), pb = drawnPlace(b), pc = drawnPlace(c);
#ifdef PARALLEL
  if (min(pa.z, min(pb.z, pc.z)) < 0.0f) return;  // skips triangles behind the camera's depth range
#endif
  if (beside(pa, pb, pc, size, nearest)) return;
  bool whole = inside(pa, size, nearest) && inside(pb, size, nearest) && inside(pc, size, nearest);
  Triangle t;
  t.empty = false;
  t.low = t.high = ivec2(0);
  if (whole) t = drawnTriangle(cornerOfVertex(a), cornerOfVertex(b), cornerOfVertex(c));
  if (t.empty) return;
#if defined BINS && !defined LAMP_MAP && !defined SUN_MAP
  int extent = 0;
  bool small = false;
  if (whole) small = bin(t, firstId + uint(number));
#else
  int extent = drawnAs(t);
  bool small = whole && extent <= smallPixels * subpixels / smallerBy;
#endif
#if defined BINS && (defined LAMP_MAP || defined SUN_MAP)
  if (whole && !small && bin(t, firstId + uint(number))) return;
#endif
  if (!small) {
#if PASS == 0
    if (whole && extent > 0 && extent <= mediumPixels * subpixels)
      large[firstIndex / 3 + triangleCount - 1 - int(nextPlace(draws + draw_))] = uint(number);
    else
      large[firstIndex / 3 + int(nextPlace(draw_))] = uint(number);
#endif
    return;
  }
#if !defined BINS || defined LAMP_MAP || defined SUN_MAP
#ifdef CUTOUT
  cutTriangle(corners, placeOf(a), placeOf(b), placeOf(c));
#endif
  fillBox(t, firstId + uint(number));
#endif
}

void main() {
#ifdef FACES
  int count = trianglesToDraw();
  for (int i = int(gl_GlobalInvocationID.x); i < count; i += int(gl_NumWorkGroups.x) * 64) drawOrList(i);
#else
  int number = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (number < trianglesToDraw()) drawOrList(number);
#endif
}

// Small triangles of one surface, an invocation each; the numbers of the others go on a list: those of medium size from its
// end on (medium.comp), large ones from its beginning (large.comp). SAMPLES, PASS, SUN_MAP, LAMP_MAP, COUNTED, BALLOT. BINS:
// those that are whole are listed by tiles (bins.glsl) instead of drawn, of maps those that are not very small.
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
uniform int draw_;         // number of the surface among those drawn
#endif
uniform int draws;
uniform int mediumPixels;  // the longest side of a box of medium size; none is where that is less than smallPixels
#include "draw/exact/list_place.glsl"
#if defined BINS && (defined LAMP_MAP || defined SUN_MAP)
// Maps have one sample a pixel and no numbers, so a few atomics are less work than a tile's samples.
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
  if (min(pa.z, min(pb.z, pc.z)) < 0.0f) return;  // beyond the span
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

// Rasterizes the small triangles of visible mesh copies, one per invocation. Appends larger triangles to a list:
// medium-sized ones from the list's end (medium_copies.comp), large ones from its start (large_copies.comp). Defines:
// as for raster_triangle.glsl, and BALLOT.
#include "draw/exact/copies/raster_copy.glsl"
#include "draw/exact/triangles/fill_box.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = largeBinding) writeonly restrict buffer LargeBlock { uint large[]; };
layout(std430, binding = counterBinding) restrict buffer CounterBlock { uint counters[]; };
layout(binding = counterUnit) uniform usamplerBuffer listedCounts;
uniform int draw_;        // index of the current mesh copies among all drawn copies
uniform int part;         // index of the current dispatch
uniform int copyLimit;   // max number of copies in one dispatch
uniform int parts;
uniform int listRoom;      // capacity of the list of larger triangles
// Max side (pixels) of the bounding box of a medium-sized triangle. If this is not above the limit of small triangles,
// no triangle is medium-sized.
uniform int mediumPixels;
#include "draw/exact/list_place.glsl"

void main() {
  uint pair = gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x;
  int copies = min(int(texelFetch(listedCounts, draw_).x) - skipped, copyLimit);
  if (copies <= 0 || pair >= uint(copies) * triangles) return;
  CopyTriangle c = copyTriangle(pair);
  vec2 size = vec2(PICTURE_SIZE);
#ifndef SUN_MAP
  float nearest = view.near;
#endif
#ifdef PARALLEL
  if (min(c.a.z, min(c.b.z, c.c.z)) < 0.0f) return;  // skips triangles behind the camera's depth range
#endif
  if (beside(c.a, c.b, c.c, size, nearest)) return;
  bool whole = inside(c.a, size, nearest) && inside(c.b, size, nearest) && inside(c.c, size, nearest);
  Triangle t;
  t.empty = false;
  t.low = t.high = ivec2(0);
  if (whole) t = drawnTriangle(cornerAt(c.a, c.na), cornerAt(c.b, c.nb), cornerAt(c.c, c.nc));
  if (t.empty) return;
  int extent = drawnAs(t);
  if (whole && extent <= smallPixels * subpixels)
    fillBox(t, c.id);
  else if (whole && extent <= mediumPixels * subpixels)
    large[listRoom - 1 - int(nextPlace(parts + part))] = pair;
  else
    large[int(nextPlace(part))] = pair;
}

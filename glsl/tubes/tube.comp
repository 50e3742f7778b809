// Computes tubes around lines of points. One invocation per tube, because each ring is rotated from the ring before it
// by the smallest rotation that follows the line (parallel transport), so that the tube does not twist. A line has a
// ring at each of its points, and one more at each end, of radius 0, which closes the tube. Rings outside the line's
// span are at its ends.
#include "common/exact.glsl"
#include "common/memory.glsl"
layout(local_size_x = 32) in;
INPUT_ARRAY(0, PointBlock, points)    // xyz: position, m; w: position in the palette, 0 to 1
INPUT_ARRAY(1, PaletteBlock, palette)  // linear RGB colours
STATE_ARRAY(2, VertexBlock, vertices)
STATE_ARRAY(3, NormalBlock, normals)
STATE_ARRAY(4, ColorBlock, colors)
layout(std430, binding = 5) readonly buffer SpanBlock { ivec4 spans[]; };  // x, y: indices of the first and last point;
                                                                           // z: line
uniform int lines;         // number of tubes
uniform int lineRoom;      // number of points per line in `points`
uniform float radius;      // m
uniform float taperFirst;  // 1 / number of points after the first point over which the tube widens
uniform float taperLast;   // 1 / number of points before the last point over which the tube narrows
uniform float fade;        // fraction by which the colour is darkened at the last point
uniform int paletteSize;
uniform vec2 circle[6];    // unit vectors from the centre of a ring to its vertices

vec3 unitOr(vec3 v, vec3 other) {
  float squared = exactDot(v, v);
  precise vec3 unit = v * exactInverseSqrt(max(squared, 1e-30));
  return squared > 1e-20 ? unit : other;
}

// Returns a unit vector perpendicular to t.
vec3 besides(vec3 t) {
  vec3 axis = abs(t.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
  return unitOr(exactCross(axis, t), vec3(0.0, 1.0, 0.0));
}

vec3 paletteAt(float place) {
  precise float at = clamp(place, 0.0, 1.0) * float(paletteSize - 1);
  int below = clamp(int(at), 0, max(paletteSize - 2, 0));
  precise float rest = at - float(below);
  return exactMix(LOAD_INPUT(palette, below).rgb, LOAD_INPUT(palette, min(below + 1, paletteSize - 1)).rgb, rest);
}

void main() {
  int line = int(gl_GlobalInvocationID.x);
  if (line >= lines) return;
  ivec3 span = spans[line].xyz;
  int base = span.z * lineRoom;
  bool none = span.y <= span.x;
  int first = clamp(span.x, 0, lineRoom - 1), last = none ? first : clamp(span.y, 0, lineRoom - 1);
  float perSpan = exactReciprocal(float(max(last - first, 1)));
  // A taper extends over at most the whole line; if both ends have tapers, each extends over at most two fifths of it.
  bool oneSided = taperFirst > 1e5 || taperLast > 1e5;
  precise float shortest = perSpan * (oneSided ? 1.0 : 2.5);
  vec3 start = LOAD_INPUT(points, base + first).xyz;
  precise vec3 toNext = LOAD_INPUT(points, base + min(first + 1, last)).xyz - start;
  vec3 along = unitOr(toNext, vec3(0.0, 0.0, 1.0));
  vec3 side = besides(along);
  for (int ring = 0; ring < lineRoom + 2; ++ring) {
    int wanted = ring - 1, i = clamp(wanted, first, last);
    vec4 here = LOAD_INPUT(points, base + i);
    precise vec3 way = LOAD_INPUT(points, base + min(i + 1, last)).xyz - LOAD_INPUT(points, base + max(i - 1, first)).xyz;
    along = unitOr(way, along);
    precise vec3 flat_ = side - along * exactDot(along, side);
    side = unitOr(flat_, besides(along));
    vec3 up = exactCross(along, side);
    precise float passed = float(i - first);
    precise float rest = float(last - i);
    precise float rising = passed * max(taperFirst, shortest);
    precise float falling = rest * max(taperLast, shortest);
    precise float wide = radius * min(1.0, min(rising, falling));
    // Without a taper, the end points have the full radius.
    wide = (taperFirst > 1e5 && i == first) || (taperLast > 1e5 && i == last) ? radius : wide;
    bool open = !none && wanted == i;
    precise float dark = 1.0 - fade * (passed * perSpan);
    precise vec3 tint = paletteAt(here.w) * dark;
    for (int k = 0; k < 6; ++k) {
      precise vec3 outward = side * circle[k].x + up * circle[k].y;
      precise vec3 vertex = here.xyz + outward * (open ? wide : 0.0);
      vec3 cap = wanted < first ? -along : along;
      int slot = (line * (lineRoom + 2) + ring) * 6 + k;
      STORE_STATE(vertices, slot, vec4(vertex, 1.0));
      STORE_STATE(normals, slot, vec4(open ? outward : cap, 0.0));
      STORE_STATE(colors, slot, vec4(tint, 1.0));
    }
  }
}

// Brush strokes on a grid of cells, in exact arithmetic. Compiles as GLSL and as C++ (src/sim/grid/strokes.hpp).
#ifndef FUNCTION
#define FUNCTION
#endif

struct Stroke {
  vec4 segment;  // cells: where the brush is at the step's beginning (xy) and at its end (zw)
  vec4 shape;    // radius^2 (cells^2), 1 / length^2 of the segment (0: a point), value painted, unused
  ivec4 image;   // of an image stamp: left, top (cells), first word of its bits, its width; width 0: no image
  ivec4 random;  // seed, share of cells painted as 2^24 * share, height of the image, 0
};

// Whether the middle of `cell` lies within the brush's radius of its segment: distance to the point
// from + clamp((p - from).d / d.d) d.
FUNCTION bool strokeReaches(Stroke s, ivec2 cell) {
  precise float px = float(cell.x) + 0.5f - s.segment.x;
  precise float py = float(cell.y) + 0.5f - s.segment.y;
  precise float dx = s.segment.z - s.segment.x;
  precise float dy = s.segment.w - s.segment.y;
  precise float along = (px * dx + py * dy) * s.shape.y;
  along = clamp(along, 0.0f, 1.0f);
  precise float qx = px - along * dx;
  precise float qy = py - along * dy;
  precise float distance2 = qx * qx + qy * qy;
  return distance2 <= s.shape.x;
}

// Whether this cell is among the share that a sparse stroke paints.
FUNCTION bool strokePicks(Stroke s, ivec2 cell) {
  return int(hash3(uvec3(uint(cell.x), uint(cell.y), uint(s.random.x))).x >> 8u) < s.random.y;
}

// Brush strokes on a grid of cells, in exact arithmetic. Compiles as GLSL and as C++ (src/sim/grid/strokes.hpp).

struct Stroke {
  vec2 from;         // cells: where the brush is at the step's beginning,
  vec2 to;           // and at its end
  float radius2;     // cells^2
  float perLength2;  // 1 / length^2 of the segment, 0: a point
  float value;       // painted
  int seed;
  int picked;        // 2^24 times the fraction of cells painted
  int imageWord;     // of an image stamp: the first of its bits,
  ivec2 imageFrom;   // the cell of its top left,
  ivec2 imageSize;   // pixels; 0, 0: no image
};

// Whether the middle of `cell` lies within the brush's radius of its segment: distance to the point
// from + clamp((p - from).d / d.d) d.
FUNCTION bool strokeReaches(Stroke s, ivec2 cell) {
  precise float px = float(cell.x) + 0.5f - s.from.x;
  precise float py = float(cell.y) + 0.5f - s.from.y;
  precise float dx = s.to.x - s.from.x;
  precise float dy = s.to.y - s.from.y;
  precise float along = (px * dx + py * dy) * s.perLength2;
  along = clamp(along, 0.0f, 1.0f);
  precise float qx = px - along * dx;
  precise float qy = py - along * dy;
  precise float distance2 = qx * qx + qy * qy;
  return distance2 <= s.radius2;
}

// The value as a whole number.
FUNCTION int strokeNumber(Stroke s) {
  precise float rounded = s.value + 0.5f;
  return int(rounded);
}

// Whether this cell is among the fraction that a sparse stroke paints.
FUNCTION bool strokePicks(Stroke s, ivec2 cell) {
  return int(hash3(uvec3(uint(cell.x), uint(cell.y), uint(s.seed))).x >> 8u) < s.picked;
}

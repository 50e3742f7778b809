// Brush strokes on a grid of cells, in exact arithmetic. Compiles as GLSL and as C++ (src/sim/grid/strokes.hpp).

struct Stroke {
  vec2 from;         // Brush position at the step's start, in cells
  vec2 to;           // Brush position at the step's end, in cells
  float radius2;     // Squared radius, cells^2
  float perLength2;  // 1 / squared length of the segment, or 0 for a point
  float value;       // Painted value
  int seed;
  int picked;        // 2^24 times the fraction of cells that are painted
  int imageWord;     // Image stamp: index of the word with its first bit
  ivec2 imageFrom;   // Image stamp: cell of the top left pixel
  ivec2 imageSize;   // Image stamp: size in pixels; (0, 0) if there is no image
};

// True if the centre of `cell` lies within the brush's radius of the segment: distance to the point from + clamp((p -
// from).d / d.d) d.
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

// Returns the painted value rounded to an integer.
FUNCTION int strokeNumber(Stroke s) {
  precise float rounded = s.value + 0.5f;
  return int(rounded);
}

// True if the cell is in the fraction that a sparse stroke paints.
FUNCTION bool strokePicks(Stroke s, ivec2 cell) {
  return int(hash3(uvec3(uint(cell.x), uint(cell.y), uint(s.seed))).x >> 8u) < s.picked;
}

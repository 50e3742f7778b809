// Brush strokes on a grid of cells, in exact arithmetic. Compiles as GLSL and as C++ (src/sim/grid/strokes.hpp).

struct Stroke {
  vec2 from;         // Brush position at the start of the step, in cells
  vec2 to;           // Brush position at the end of the step, in cells
  float radius2;     // Squared radius, cells^2
  float perLength2;  // 1 / squared length of the segment, or 0 for a point
  float value;       // Painted value
  int seed;
  int picked;        // Fraction of cells that are painted, multiplied by 2^24
  int imageWord;     // For an image: index of the word that holds the image's first bit
  ivec2 imageFrom;   // For an image: cell of its top left pixel
  ivec2 imageSize;   // For an image: size in pixels; (0, 0) if there is no image
};

// Returns true if the distance from the centre p of `cell` to the segment is at most the brush's radius. The nearest
// point of the segment is from + clamp((p - from).d / d.d) d, where d = to - from.
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

// Returns true if the cell is in the fraction of cells that a sparse stroke paints.
FUNCTION bool strokePicks(Stroke s, ivec2 cell) {
  return int(hash3(uvec3(uint(cell.x), uint(cell.y), uint(s.seed))).x >> 8u) < s.picked;
}

// Lines of points that start from seeds, and the spans of the lines.
#include "common/exact.glsl"
#include "common/memory.glsl"
layout(local_size_x = 32) in;
STATE_ARRAY(0, PointBlock, points)  // xyz: position, m; w: position in the colour map, 0 to 1
// For each line: x, y are the indices of the current first and last point; z, w are the indices of the first and last
// point of the traced line. For a line without points, the last index is below the first.
layout(std430, binding = 1) buffer SpanBlock { ivec4 spans[]; };
uniform int count;           // number of lines
const int aside = 40;        // number of points on each side of the seed, which is the middle point
const int perLine = 81;      // number of points per line

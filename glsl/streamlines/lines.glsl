// Lines of points from seeds, and their spans.
#include "common/exact.glsl"
#include "common/memory.glsl"
layout(local_size_x = 32) in;
STATE_ARRAY(0, PointBlock, points)  // x, y, z: m; w: colour, 0 to 1
// Per line: x, y: first and last point now; z, w: as traced. A line without points has its last below its first.
layout(std430, binding = 1) buffer SpanBlock { ivec4 spans[]; };
uniform int count;           // lines
const int aside = 40;        // points on each side of the seed, which is the middle point
const int perLine = 81;      // points per line

// Lists the remaining lines in the order of their seeds, and writes the number of indices to draw. One invocation in
// total.
layout(local_size_x = 1) in;
layout(std430, binding = 0) readonly buffer SpanBlock { ivec4 spans[]; };   // x, y: indices of the first and last point
                                                                            // of each line
layout(std430, binding = 1) writeonly buffer TubeBlock { ivec4 tubeSpans[]; };  // x, y: indices of the first and last
                                                                                // point of each tube; z: its line
layout(std430, binding = 2) writeonly buffer ArgumentBlock { uint arguments[]; };
uniform int count;  // number of lines
uniform int tubes;  // maximum number of tubes
uniform int indicesPerTube;

void main() {
  int used = 0;
  for (int line = 0; line < count; ++line) {
    ivec4 span = spans[line];
    if (span.x >= span.y || used == tubes) continue;
    tubeSpans[used] = ivec4(span.xy, line, 0);
    ++used;
  }
  arguments[0] = uint(used * indicesPerTube);
  for (int tube = used; tube < tubes; ++tube) tubeSpans[tube] = ivec4(0, -1, 0, 0);
}

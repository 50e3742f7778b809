// Adds the change of light by reflections to the light of the pixels. The change is computed at the first pixel of each
// half pixel. The other pixels receive the bilinear mean of the changes around them, unless they or their neighbours
// also show other parts (draw/exact/tiles/half_tile.glsl). Without the mean, outlines of reflected objects would be
// stairs of 2x2 pixels. One invocation handles ROWS half pixels, one below the other.
#include "draw/exact/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
layout(rgba32f, binding = lightImage) readonly restrict uniform image2D changes;
layout(rgba32f, binding = sumImage) restrict uniform image2D sums;
uniform ivec2 size;  // picture size in pixels

vec4 changeAt(ivec2 pixel) {
  return pixel.x < size.x && pixel.y < size.y ? imageLoad(changes, pixel) : vec4(0.0f);
}

// Returns the part whose number is in the alpha of pixel 0 of a half pixel, or -1.
int partIn(vec4 change) {
  return change.a > 0.0f ? int(change.a) >> 4 : -1;
}

// Returns the mean of a change and of a neighbour's, or only the first one if the neighbour shows another part.
vec3 meanOf(vec3 own, vec4 beside, int part) {
  vec3 other = partIn(beside) == part ? beside.rgb : own;
  precise vec3 mean = 0.5f * (own + other);
  return mean;
}

void addChange(ivec2 pixel, vec3 change) {
  if (pixel.x >= size.x || pixel.y >= size.y || change == vec3(0.0f)) return;
  precise vec4 sum = imageLoad(sums, pixel) + vec4(change, 0.0f);
  imageStore(sums, pixel, sum);
}

void main() {
  ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, ROWS);
  for (int row = 0; row < ROWS; ++row) {
    ivec2 pixel = 2 * (first + ivec2(0, row));
    if (pixel.x >= size.x || pixel.y >= size.y) continue;
    vec4 own = changeAt(pixel), right = changeAt(pixel + ivec2(2, 0));
    vec4 below = changeAt(pixel + ivec2(0, 2)), across = changeAt(pixel + 2);
    vec3 b = changeAt(pixel + ivec2(1, 0)).rgb, c = changeAt(pixel + ivec2(0, 1)).rgb, d = changeAt(pixel + 1).rgb;
    int part = partIn(own), whole = part < 0 ? 0 : int(own.a) & 15;
    if ((whole & 2) != 0) b = meanOf(b, right, part);
    if ((whole & 4) != 0) c = meanOf(c, below, part);
    vec3 lower = meanOf(partIn(below) == part ? below.rgb : d, across, part);
    precise vec3 middle = 0.5f * (meanOf(d, right, part) + lower);
    if ((whole & 8) != 0) d = middle;
    addChange(pixel, own.rgb);
    addChange(pixel + ivec2(1, 0), b);
    addChange(pixel + ivec2(0, 1), c);
    addChange(pixel + 1, d);
  }
}

// Writes the indices of the pixels of a view that lens_shift.comp shows at each pixel. The coverage of objects is then
// blurred as the light is. One invocation handles one pixel.
#include "draw/exact/view_block.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32ui, binding = pictureImage) writeonly restrict uniform uimage2D sources;
#include "draw/exact/screen/lens_read.glsl"

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= view.size.x || at.y >= view.size.y) return;
  uvec4 found = uvec4(0u);
  for (int i = 0; i < pointsAPixel; ++i) {
    ivec2 from = shiftedFrom(at, pointsAPixel * number + i, lens, view.size);
    found[i] = uint(from.y * view.size.x + from.x);
  }
  imageStore(sources, at, found);
}

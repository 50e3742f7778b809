// Scales the light of the band's pixels that show several primitives of very different brightness, so that the edges of
// highlights look smooth (edge_light.glsl). Resets the sums of compressed brightness. One invocation handles one pixel.
#define EXACT_PICTURE
#include "common/exact.glsl"
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/exact/screen/edge_light.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = sumImage) restrict uniform image2D sums;
layout(r32f, binding = edgeImage) restrict uniform image2D edges;
uniform int linear;  // 1 to keep the linear averages

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, view.rows.x);
  if (at.x >= view.size.x || at.y >= view.rows.y) return;
  float compressed = imageLoad(edges, at).x;
  if (compressed == 0.0f) return;
  imageStore(edges, at, vec4(0.0f));
  if (linear == 1) return;
  vec4 light = min(imageLoad(sums, at), 6e4f);
  float factor = edgeFactor(light, compressed, frame.exposure);
  if (factor == 1.0f) return;
  precise vec3 evened = light.rgb * factor;
  imageStore(sums, at, vec4(evened, light.a));
}

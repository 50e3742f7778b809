// Lists the visible surface points (spots, see pixel_spots.glsl) of a band of rows: for each spot, the index of its
// sample and its number of rays. Clears the light of each spot. One invocation handles one pixel. SAMPLES: samples per
// pixel. PAIRED: as in draw/exact/sample_read.glsl.
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/rays/pixel_spots.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = outListBinding) writeonly restrict buffer ListBlock { uvec2 list[]; };
layout(std430, binding = outCountBinding) restrict buffer CountBlock { uint listed; };
layout(std430, binding = outSpotLightBinding) writeonly restrict buffer SpotLightBlock { vec4 spotLight[]; };
uniform int raySamples;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, view.rows.x);
  if (pixel.x >= view.size.x || pixel.y >= view.rows.y) return;
  int first = firstSample(pixel);
  for (int s = 0; s < SAMPLES; ++s) {
    int same = samplesShowing(first, s);
    if (same == 0) continue;
    list[atomicAdd(listed, 1u)] = uvec2(first + s, raysOf(same, raySamples));
    spotLight[first + s] = vec4(0);
  }
}

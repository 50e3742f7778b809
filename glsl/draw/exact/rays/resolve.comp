// Adds the ray-traced light of each pixel's visible surface points (spots, see pixel_spots.glsl) to the pixel, weighted
// by the samples that share the point. One invocation handles one pixel. SAMPLES: samples per pixel. PAIRED: as in
// draw/exact/sample_read.glsl.
#define EXACT_PICTURE
#include "draw/frame_block.glsl"
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/rays/pixel_spots.glsl"
#include "draw/exact/fixed.glsl"
#include "draw/exact/screen/edge_light.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = spotUnit) uniform usamplerBuffer spots;
layout(binding = spotLightUnit) uniform samplerBuffer spotLight;
layout(rgba32f, binding = sumImage) restrict uniform image2D sums;
#if SAMPLES > 1
layout(r32f, binding = edgeImage) restrict uniform image2D edges;
#endif
uniform int raySamples;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, view.rows.x);
  if (pixel.x >= view.size.x || pixel.y >= view.rows.y) return;
  int first = firstSample(pixel);
  precise vec4 sum = imageLoad(sums, pixel);
  precise float edge = 0.0f;
  for (int s = 0; s < SAMPLES; ++s) {
    int same = samplesShowing(first, s);
    if (same == 0) continue;
    float share = uintBitsToFloat(texelFetch(spots, 4 * (first + s) + 2).w);
    precise float part = share * float(same) * perSamples();
    float perRay = exactReciprocal(float(raysOf(same, raySamples)));
    precise float factor = part * perRay;
    vec3 light = texelFetch(spotLight, first + s).rgb;
    sum = sum + vec4(light, 0.0f) * factor;
    precise vec3 mean = light * perRay;
    precise float compressed = compressedBrightness(brightnessOf(mean, frame.exposure)) * part;
    // The sum of a pixel with blended layers or a fading ground becomes negative, which stands for a linear average.
    edge = edge + (share < 1.0f ? -1e9f : same < SAMPLES ? compressed : 0.0f);
  }
  imageStore(sums, pixel, sum);
#if SAMPLES > 1
  precise float edges_ = imageLoad(edges, pixel).x + edge;
  imageStore(edges, pixel, vec4(edges_));
#endif
}

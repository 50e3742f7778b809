// Adds the ray-traced light of each pixel's visible surface points (spots, see pixel_spots.glsl) to the pixel, weighted
// by the samples that share the point. One invocation handles one pixel. SAMPLES: samples per pixel. PAIRED: as in
// draw/exact/sample_read.glsl.
#define EXACT_PICTURE
#include "draw/frame_block.glsl"
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/rays/pixel_spots.glsl"
#include "draw/exact/fixed.glsl"
#include "draw/exact/screen/edge_light.glsl"
#include "draw/exact/haze.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = spotUnit) uniform usamplerBuffer spots;
layout(binding = spotLightUnit) uniform samplerBuffer spotLight;
layout(rgba32f, binding = sumImage) restrict uniform image2D sums;
uniform int raySamples;
uniform int linear;  // 1 to keep linear averages

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, view.rows.x);
  if (pixel.x >= view.size.x || pixel.y >= view.rows.y) return;
  int first = firstSample(pixel);
  precise vec4 sum = imageLoad(sums, pixel);
  // Light is compressed if the pixel's coverage is negative (edge_light.glsl). The emission was compressed before.
  bool compressed = linear == 0 && sum.a < 0.0f;
  float before = 0.0f;
  IF_ANY(compressed) {
    precise vec3 emitted = evenedLight(sum, frame.exposure).rgb * exactReciprocal(max(-sum.a, 1e-6f));
    before = brightnessOf(emitted, frame.exposure);
  }
  for (int s = 0; s < SAMPLES; ++s) {
    int same = samplesShowing(first, s);
    if (same == 0) continue;
    float share = uintBitsToFloat(texelFetch(spots, 4 * (first + s) + 2).w);
    precise float factor = share * float(same) * perSamples() * exactReciprocal(float(raysOf(same, raySamples)));
    vec3 light = texelFetch(spotLight, first + s).rgb;
#ifdef HAZE  // The shading kernels have added the light of the haze itself.
    precise vec3 dimmed = light * passed(hazeBefore(uintBitsToFloat(texelFetch(spots, 4 * (first + s)).xyz)));
    light = dimmed;
#endif
    precise vec3 mean = light * exactReciprocal(float(raysOf(same, raySamples)));
    float kept = compressed ? furtherCompression(before, brightnessOf(mean, frame.exposure)) : 1.0f;
    sum = sum + vec4(light, 0.0f) * (factor * kept);
  }
  imageStore(sums, pixel, sum);
}

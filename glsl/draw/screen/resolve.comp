// Averages the samples of each pixel. GLOWS: adds the glows that kernels have summed and resets the sums. SAMPLES:
// samples per pixel, 1 or more. One invocation resolves one pixel.
#include "draw/frame_block.glsl"
#include "draw/samples.glsl"
#ifdef GLOWS
#include "draw/instances/glow_block.glsl"
#endif
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = targetImage) writeonly restrict uniform image2D resolved;
layout(binding = sceneUnit) uniform SAMPLED scene;
layout(binding = depthUnit) uniform SAMPLED sceneDepth;
uniform int cleared;  // 0 if the light was not cleared; samples without depth are then skipped, because they hold light
                      // of an earlier frame

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, ivec2(frame.size)))) return;
  vec4 light = vec4(0);
  for (int i = 0; i < SAMPLES; ++i) {
    if (cleared != 0 || texelFetch(sceneDepth, at, SAMPLE(i)).x < 1.0) light += texelFetch(scene, at, SAMPLE(i));
  }
  light /= float(SAMPLES);
#ifdef GLOWS
  int word = glowWord(at);
  for (int i = 0; i < 3; ++i) {
    light[i] += float(glowSums[word + 3 + i]) * glowUpper + float(glowSums[word + i]) / glowUnits;
    glowSums[word + i] = glowSums[word + 3 + i] = 0u;
  }
#endif
  imageStore(resolved, at, min(light, 6e4));  // limits the light, because the sum of glows may exceed the half-float
                                              // range
}

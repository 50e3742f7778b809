// Copies the bits of every sample: light and depth, 5 words per sample. One invocation per sample.
#include "draw/bindings.glsl"
#include "draw/samples.glsl"
layout(local_size_x = 64) in;
layout(binding = sceneUnit) uniform SAMPLED light;
layout(binding = depthUnit) uniform SAMPLED depth;
layout(std430, binding = sampleBinding) writeonly restrict buffer SampleBlock { uint words[]; };
uniform ivec2 size;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= size.x * size.y * SAMPLES) return;
  int pixel = i / SAMPLES;
  ivec2 at = ivec2(pixel % size.x, pixel / size.x);
  uvec4 bits = floatBitsToUint(texelFetch(light, at, SAMPLE(i % SAMPLES)));
  words[5 * i] = bits.x;
  words[5 * i + 1] = bits.y;
  words[5 * i + 2] = bits.z;
  words[5 * i + 3] = bits.w;
  words[5 * i + 4] = floatBitsToUint(texelFetch(depth, at, SAMPLE(i % SAMPLES)).x);
}

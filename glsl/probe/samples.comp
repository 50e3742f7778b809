// The bits of every sample: light and depth, 5 words each.
layout(local_size_x = 64) in;
#if SAMPLES > 1
layout(binding = 0) uniform sampler2DMS light;
layout(binding = 1) uniform sampler2DMS depth;
#else
layout(binding = 0) uniform sampler2D light;
layout(binding = 1) uniform sampler2D depth;
#endif
layout(std430, binding = 0) writeonly restrict buffer SampleBlock { uint words[]; };
uniform ivec2 size;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= size.x * size.y * SAMPLES) return;
  int pixel = i / SAMPLES;
  int from = SAMPLES > 1 ? i % SAMPLES : 0;  // a level where there are no samples
  ivec2 at = ivec2(pixel % size.x, pixel / size.x);
  uvec4 bits = floatBitsToUint(texelFetch(light, at, from));
  words[5 * i] = bits.x;
  words[5 * i + 1] = bits.y;
  words[5 * i + 2] = bits.z;
  words[5 * i + 3] = bits.w;
  words[5 * i + 4] = floatBitsToUint(texelFetch(depth, at, from).x);
}

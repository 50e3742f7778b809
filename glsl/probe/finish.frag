// Averages the samples and encodes, as the last pass of a picture does.
#if SAMPLES > 1
layout(binding = 0) uniform sampler2DMS light;
#else
layout(binding = 0) uniform sampler2D light;
#endif
layout(location = 0) out vec4 color;

void main() {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < SAMPLES; ++i)
#if SAMPLES > 1
    sum += texelFetch(light, ivec2(gl_FragCoord.xy), i).rgb;
#else
    sum += texelFetch(light, ivec2(gl_FragCoord.xy), 0).rgb;
#endif
  vec3 mean = max(sum / float(SAMPLES), vec3(0.0));
  color = vec4(1.055 * pow(mean / (mean + 0.6), vec3(1.0 / 2.4)) - 0.055, 1.0);
}

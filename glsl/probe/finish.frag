// Last pass of the probe picture: averages the samples and encodes the colour like the final pass of a real picture.
#include "draw/bindings.glsl"
#include "draw/samples.glsl"
layout(binding = sceneUnit) uniform SAMPLED light;
layout(location = 0) out vec4 color;

void main() {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < SAMPLES; ++i) sum += texelFetch(light, ivec2(gl_FragCoord.xy), SAMPLE(i)).rgb;
  vec3 mean = max(sum / float(SAMPLES), vec3(0.0));
  color = vec4(1.055 * pow(mean / (mean + 0.6), vec3(1.0 / 2.4)) - 0.055, 1.0);
}

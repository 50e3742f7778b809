// Listed instances and their colours.
#include "draw/instances/instance.glsl"
layout(binding = listUnit) uniform usamplerBuffer list;
layout(binding = argumentUnit) uniform usamplerBuffer arguments;
layout(binding = stopUnit) uniform samplerBuffer stops;
uniform int level;
uniform int colorBy;  // sim::Instances::ColorBy
uniform int stopCount;
uniform vec3 color;
uniform float colorFactor;  // value * factor + offset is 0 to 1 over the range
uniform float colorOffset;
uniform float brightness;
uniform float fade;  // fraction of life to fade in and out

// Number `at` of the level's visible ones; false where there are fewer.
bool listed(uint at, out vec4 position, out vec4 velocity) {
  position = velocity = vec4(0);
  if (at >= texelFetch(arguments, level * 8 + 6).x) return false;
  int slot = int(texelFetch(list, int(texelFetch(arguments, level * 8 + 5).x + at)).x);
  position = texelFetch(positions, slot);
  velocity = texelFetch(velocities, slot);
  return true;
}

vec3 tintOf(vec4 position, vec4 velocity) {
  if (colorBy == 0) return color;
  float value = colorBy == 1 ? length(velocity.xyz) : colorBy == 2 ? position.w : velocity.w;
  float at = clamp(value * colorFactor + colorOffset, 0.0, 1.0) * float(stopCount - 1);
  int below = min(int(at), max(stopCount - 2, 0));
  return mix(texelFetch(stops, below).rgb, texelFetch(stops, min(below + 1, stopCount - 1)).rgb, at - float(below));
}

// Light of an additive instance for its colour: it brightens and dims over its life. One whose age is exactly 0
// does not age.
float brightnessAt(float age) {
  if (fade <= 0.0 || age == 0.0) return brightness;
  float fraction = clamp(min(age, 1.0 - age) / fade, 0.0, 1.0);
  return brightness * fraction * fraction * (3.0 - 2.0 * fraction);
}

struct Glow {
  vec3 middle;
  float radius;  // m
  vec3 light;
};

// An additive sprite. One too small to be drawn is widened and keeps its light: it is dimmer by the ratio of areas.
Glow glowOf(vec4 position, vec4 velocity) {
  float radius = instanceSize(position.w) * shapeRadius;
  float minimum = minRadius(position.xyz);
  float fraction = min(radius / max(minimum, 1e-12), 1.0);
  vec3 light = tintOf(position, velocity) * (brightnessAt(velocity.w) * fraction * fraction);
  return Glow(position.xyz, max(radius, minimum), light);
}

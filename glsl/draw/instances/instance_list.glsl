// Listed instances and their colours.
#include "common/once.glsl"
#include "draw/instances/instance.glsl"
layout(binding = listUnit) uniform usamplerBuffer list;
layout(binding = argumentUnit) uniform usamplerBuffer arguments;
layout(binding = stopUnit) uniform samplerBuffer stops;
uniform int level;
uniform int colorBy;  // sim::Instances::ColorBy
int colorBy_ = once(colorBy);
uniform int stopCount;
int stopCount_ = once(stopCount);
uniform vec3 color;
vec3 color_ = once(color);
uniform float colorFactor;  // value * factor + offset is 0 to 1 over the range
float colorFactor_ = once(colorFactor);
uniform float colorOffset;
float colorOffset_ = once(colorOffset);
uniform float brightness;
float brightness_ = once(brightness);
uniform float fade;  // fraction of life to fade in and out
float fade_ = once(fade);

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
  if (colorBy_ == 0) return color_;
  float speed = exactSqrt(exactDot(velocity.xyz, velocity.xyz));
  float value = colorBy_ == 1 ? speed : colorBy_ == 2 ? position.w : velocity.w;
  precise float fraction = value * colorFactor_ + colorOffset_;
  precise float at = clamp(fraction, 0.0, 1.0) * float(stopCount_ - 1);
  int below = min(int(at), max(stopCount_ - 2, 0));
  precise float rest = at - float(below);
  return exactMix(texelFetch(stops, below).rgb, texelFetch(stops, min(below + 1, stopCount_ - 1)).rgb, rest);
}

// Light of an additive instance for its colour: it brightens and dims over its life. One whose age is exactly 0
// does not age.
float brightnessAt(float age) {
  if (fade_ <= 0.0 || age == 0.0) return brightness_;
  precise float left = 1.0 - age;
  precise float risen = min(age, left) * exactReciprocal(fade_);
  float fraction = clamp(risen, 0.0, 1.0);
  precise float bright = brightness_ * fraction * fraction * (3.0 - 2.0 * fraction);
  return bright;
}

struct Glow {
  vec3 middle;
  float radius;  // m
  vec3 light;
};

// An additive sprite. One too small to be drawn is widened and keeps its light: it is dimmer by the ratio of areas.
Glow glowOf(vec4 position, vec4 velocity) {
  float radius = instanceRadius(position.w);
  float minimum = minRadius(position.xyz);
  precise float ratio = radius * exactReciprocal(max(minimum, 1e-12));
  float fraction = min(ratio, 1.0);
  precise vec3 light = tintOf(position, velocity) * (brightnessAt(velocity.w) * fraction * fraction);
  return Glow(position.xyz, max(radius, minimum), light);
}

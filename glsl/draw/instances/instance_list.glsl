// Reads the list of visible instances, and computes their colours.
#include "common/once.glsl"
#include "draw/instances/instance.glsl"
layout(binding = listUnit) uniform usamplerBuffer list;
layout(binding = argumentUnit) uniform usamplerBuffer arguments;
layout(binding = stopUnit) uniform samplerBuffer stops;
uniform int level;
uniform int colorBy;  // attribute that selects the colour, a value of sim::Instances::ColorBy
int colorBy_ = once(colorBy);
uniform int stopCount;
int stopCount_ = once(stopCount);
uniform vec3 color;
vec3 color_ = once(color);
uniform float colorFactor;  // value * colorFactor + colorOffset maps the colour range to 0..1
float colorFactor_ = once(colorFactor);
uniform float colorOffset;
float colorOffset_ = once(colorOffset);
uniform float brightness;
float brightness_ = once(brightness);
uniform float fade;  // fraction of an instance's life during which it fades in, and the fraction during which it fades
                     // out
float fade_ = once(fade);

int listedSlot = 0;  // index of the instance that listed() read last
// Reads visible instance number `at` of the current level of detail. Returns false if the level has fewer instances.
bool listed(uint at, out vec4 position, out vec4 velocity) {
  position = velocity = vec4(0);
  if (at >= texelFetch(arguments, level * 8 + 6).x) return false;
  int slot = int(texelFetch(list, int(texelFetch(arguments, level * 8 + 5).x + at)).x);
  listedSlot = slot;
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

// Returns the brightness factor of an additive instance, which fades in and out over its life. An instance of age
// exactly 0 does not age.
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
  float radius;  // radius of the glow in metres
  vec3 light;
};

// Returns an additive sprite. A sprite below the min radius is enlarged and dimmed by the ratio of the areas, so that
// the total light stays the same.
Glow glowOf(vec4 position, vec4 velocity) {
  float radius = instanceRadius(position.w);
  float minimum = minRadius(position.xyz);
  precise float ratio = radius * exactReciprocal(max(minimum, 1e-12));
  float fraction = min(ratio, 1.0);
  precise vec3 light = tintOf(position, velocity) * (brightnessAt(velocity.w) * fraction * fraction);
  return Glow(position.xyz, max(radius, minimum), light);
}

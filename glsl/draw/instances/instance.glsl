// One instance of a sim::Instances by its slot.
#include "common/once.glsl"
#include "common/exact.glsl"
#include "draw/bindings.glsl"
layout(binding = positionUnit) uniform samplerBuffer positions;   // xyz (m), w mass (kg)
layout(binding = velocityUnit) uniform samplerBuffer velocities;  // xyz (m/s), w age 0 to 1, negative: not alive
uniform float size;         // factor on the shape's coordinates
float size_ = once(size);
uniform float shapeRadius;  // of a ball around the shape at size 1
float shapeRadius_ = once(shapeRadius);
uniform float massExponent;
float massExponent_ = once(massExponent);
uniform float perMassReference;  // 1/kg
float perMassReference_ = once(perMassReference);
uniform float minPixels;  // no ball is drawn with a smaller radius on screen
float minPixels_ = once(minPixels);

// Dead ones and lost ones are not drawn.
bool isShown(vec4 position, vec4 velocity) {
  precise float far = abs(position.x) + abs(position.y) + abs(position.z);
  return velocity.w >= 0.0 && isNumber(far) && far < 1e6;
}

float instanceSize(float mass) {
  if (massExponent_ == 0.0) return size_;
  precise float masses = max(mass, 0.0) * perMassReference_;
  precise float scaled = size_ * exactPow(masses, massExponent_);
  return scaled;
}

// Of a ball around it (m).
float instanceRadius(float mass) {
  precise float radius = instanceSize(mass) * shapeRadius_;
  return radius;
}

// Pixels that one metre spans at one metre from the eye.
float pixelsPerMetre() {
  precise float pixels = 0.5 * frame.size.y * exactInverseSqrt(exactDot(frame.rayUp.xyz, frame.rayUp.xyz));
  return pixels;
}

// Along the view's axis (m).
float distanceOf(vec3 p) {
  precise vec3 aside = frame.eye.w * p - frame.eye.xyz;
  return exactDot(aside, frame.rayForward.xyz);
}

// Pixels that `radius` (m) spans at p.
float pixelsOf(vec3 p, float radius) {
  precise float pixels = radius * pixelsPerMetre() * exactReciprocal(max(distanceOf(p), 1e-6));
  return pixels;
}

// Metres that `minPixels` span at p.
float minRadius(vec3 p) {
  precise float metres = max(distanceOf(p), 0.0) * minPixels_ * exactReciprocal(pixelsPerMetre());
  return metres;
}

vec4 clipPlace(vec3 p) {
  mat4 m = frame.viewProjection;
  precise vec4 place = m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
  return place;
}

#if !defined FOR_LIGHT && !defined FOR_LAMPS
// Radius on screen, pixels, of a ball's nearest point.
float pixelRadius(vec3 p, float radius) {
  precise float nearest = distanceOf(p) - radius;
  precise float pixels = radius * pixelsPerMetre() * exactReciprocal(max(nearest, 1e-3));
  return pixels;
}

// A point is dropped as a whole with its middle.
bool isMiddleSeen(vec3 p) {
  vec4 place = clipPlace(p);
  precise float border = 0.9999 * place.w;
  return all(lessThan(abs(place.xyz), vec3(border)));
}
#endif

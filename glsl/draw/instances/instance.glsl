// One instance of a sim::Instances by its slot.
#include "draw/bindings.glsl"
layout(binding = positionUnit) uniform samplerBuffer positions;   // xyz (m), w mass (kg)
layout(binding = velocityUnit) uniform samplerBuffer velocities;  // xyz (m/s), w age 0 to 1, negative: not alive
uniform float size;         // factor on the shape's coordinates
uniform float shapeRadius;  // of a ball around the shape at size 1
uniform float massExponent;
uniform float perMassReference;  // 1/kg
uniform float minPixels;  // no ball is drawn with a smaller radius on screen

// Dead ones and lost ones are not drawn.
bool isShown(vec4 position, vec4 velocity) {
  return velocity.w >= 0.0 && dot(abs(position.xyz), vec3(1)) < 1e6;
}

float instanceSize(float mass) {
  if (massExponent == 0.0) return size;
  return size * pow(max(mass, 0.0) * perMassReference, massExponent);
}

// Pixels that one metre spans at one metre from the eye.
float pixelsPerMetre() {
  return 0.5 * frame.size.y * inversesqrt(dot(frame.rayUp.xyz, frame.rayUp.xyz));
}

// Pixels that `radius` (m) spans at p.
float pixelsOf(vec3 p, float radius) {
  return radius * pixelsPerMetre() / max(dot(p - frame.eye.xyz, frame.rayForward.xyz), 1e-6);
}

// Metres that `minPixels` span at p.
float minRadius(vec3 p) {
  return max(dot(p - frame.eye.xyz, frame.rayForward.xyz), 0.0) * minPixels / pixelsPerMetre();
}

#if !defined FOR_LIGHT && !defined FOR_LAMPS
// Radius on screen, pixels, of a ball's nearest point.
float pixelRadius(vec3 p, float radius) {
  float distance = max(dot(p - frame.eye.xyz, frame.rayForward.xyz) - radius, 1e-3);
  return radius * pixelsPerMetre() / distance;
}

// A point is dropped as a whole with its middle.
bool isMiddleSeen(vec3 p) {
  vec4 place = frame.viewProjection * vec4(p, 1);
  return all(lessThan(abs(place.xyz), vec3(0.9999 * place.w)));
}
#endif

// Reads one instance of a sim::Instances by its index.
#include "common/once.glsl"
#include "common/exact.glsl"
#include "draw/bindings.glsl"
layout(binding = positionUnit) uniform samplerBuffer positions;   // xyz: position (m); w: mass (kg)
// xyz: velocity (m/s); w: age 0 to 1, negative if the instance is not alive
layout(binding = velocityUnit) uniform samplerBuffer velocities;
uniform float size;         // scale factor of the shape's coordinates
float size_ = once(size);
uniform float shapeRadius;  // radius of the shape's bounding sphere at size 1
float shapeRadius_ = once(shapeRadius);
uniform float massExponent;
float massExponent_ = once(massExponent);
uniform float perMassReference;  // 1 / reference mass (1/kg); the size is multiplied by (mass / reference
                                 // mass)^massExponent
float perMassReference_ = once(perMassReference);
uniform float minPixels;  // min radius (pixels) of an instance in the picture
float minPixels_ = once(minPixels);

// Returns true if the instance is alive and its position is finite and not extremely far away.
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

// Returns the radius of the instance's bounding sphere (m).
float instanceRadius(float mass) {
  precise float radius = instanceSize(mass) * shapeRadius_;
  return radius;
}

// Returns the number of pixels that one metre spans at a distance of one metre.
float pixelsPerMetre() {
  precise float pixels = 0.5 * frame.size.y * exactInverseSqrt(exactDot(frame.rayUp.xyz, frame.rayUp.xyz));
  return pixels;
}

// Returns the distance of p from the eye along the view direction (m).
float distanceOf(vec3 p) {
  precise vec3 aside = frame.eye.w * p - frame.eye.xyz;
  return exactDot(aside, frame.rayForward.xyz);
}

// Returns the number of pixels that `radius` (m) spans at p.
float pixelsOf(vec3 p, float radius) {
  precise float pixels = radius * pixelsPerMetre() * exactReciprocal(max(distanceOf(p), 1e-6));
  return pixels;
}

// Returns the length (m) that `minPixels` pixels span at p.
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
// Returns the radius (pixels) of a ball in the picture, at the distance of the ball's nearest point.
float pixelRadius(vec3 p, float radius) {
  precise float nearest = distanceOf(p) - radius;
  precise float pixels = radius * pixelsPerMetre() * exactReciprocal(max(nearest, 1e-3));
  return pixels;
}

// Returns true if the centre is in view. OpenGL clips a point primitive as a whole by its centre.
bool isMiddleSeen(vec3 p) {
  vec4 place = clipPlace(p);
  precise float border = 0.9999 * place.w;
  return all(lessThan(abs(place.xyz), vec3(border)));
}
#endif

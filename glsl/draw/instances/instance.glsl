// One instance of a sim::Instances by its slot.
layout(binding = 0) uniform samplerBuffer positions;   // xyz (m), w mass (kg)
layout(binding = 6) uniform samplerBuffer velocities;  // xyz (m/s), w age 0 to 1, negative: not alive
uniform float size;         // factor on the shape's coordinates
uniform float shapeRadius;  // of a ball around the shape at size 1
uniform vec2 massScale;     // x exponent, y 1 / reference mass
uniform float leastPixels;  // no ball is drawn with a smaller radius on screen

// Dead ones and lost ones are not drawn.
bool isShown(vec4 position, vec4 velocity) {
  return velocity.w >= 0.0 && dot(abs(position.xyz), vec3(1)) < 1e6;
}

float instanceSize(float mass) {
  if (massScale.x == 0.0) return size;
  return size * pow(max(mass, 0.0) * massScale.y, massScale.x);
}

// Pixels that one metre spans at one metre from the eye.
float pixelsPerMetre() {
  return 0.5 * frame.lens.w * inversesqrt(dot(frame.rayUp.xyz, frame.rayUp.xyz));
}

// Metres that `leastPixels` span at p.
float leastRadius(vec3 p) {
  return max(dot(p - frame.eye.xyz, frame.rayForward.xyz), 0.0) * leastPixels / pixelsPerMetre();
}

#ifndef FOR_LIGHT
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

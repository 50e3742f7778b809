// A square through a ball's middle that faces the eye.
struct Facing {
  vec3 towards;  // the eye; unit, as are
  vec3 right;    // the square's axes
  vec3 up;
  float distance;  // from the eye (m)
};

Facing facingEye(vec3 p) {
  vec3 toEye = frame.eye.xyz - p;
  float distance = max(length(toEye), 1e-6);
  vec3 towards = toEye / distance;
  vec3 right = normalize(cross(frame.rayUp.xyz, towards));
  return Facing(towards, right, cross(towards, right), distance);
}

// Radius on the square of a ball's outline, which seen from nearby is wider than the ball.
float outlineRadius(float radius, float distance) {
  return radius * inversesqrt(max(1.0 - radius * radius / (distance * distance), 0.05));
}

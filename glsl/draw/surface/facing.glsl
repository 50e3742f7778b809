#include "common/exact.glsl"
// A square through a ball's centre that faces the eye.
struct Facing {
  vec3 towards;  // unit vector to the eye
  vec3 right;    // unit vectors: axes of the square that faces the eye
  vec3 up;
  float distance;  // distance of the ball's centre from the eye (m)
};

Facing facingEye(vec3 p) {
  precise vec3 toEye = frame.eye.xyz - frame.eye.w * p;
  float distance2 = max(exactDot(toEye, toEye), 1e-12);
  precise vec3 towards = toEye * exactInverseSqrt(distance2);
  vec3 across = exactCross(frame.rayUp.xyz, towards);
  precise vec3 right = across * exactInverseSqrt(exactDot(across, across));
  return Facing(towards, right, exactCross(towards, right), exactSqrt(distance2));
}

// Returns the radius of a ball's outline on the square. Perspective makes the outline of a near ball wider than the
// ball.
float outlineRadius(float radius, float distance) {
  precise float sine = radius * exactReciprocal(distance);
  precise float cosine2 = 1.0 - sine * sine;
  precise float outline = radius * exactInverseSqrt(max(cosine2, 0.05));
  return outline;
}

#include "common/exact.glsl"
// A square through a ball's middle that faces the eye.
struct Facing {
  vec3 towards;  // the eye; unit, as are
  vec3 right;    // the square's axes
  vec3 up;
  float distance;  // from the eye (m)
};

Facing facingEye(vec3 p) {
  precise vec3 toEye = frame.eye.xyz - frame.eye.w * p;
  float distance2 = max(exactDot(toEye, toEye), 1e-12);
  precise vec3 towards = toEye * exactInverseSqrt(distance2);
  vec3 across = exactCross(frame.rayUp.xyz, towards);
  precise vec3 right = across * exactInverseSqrt(exactDot(across, across));
  return Facing(towards, right, exactCross(towards, right), exactSqrt(distance2));
}

// Radius on the square of a ball's outline, which seen from nearby is wider than the ball.
float outlineRadius(float radius, float distance) {
  precise float sine = radius * exactReciprocal(distance);
  precise float cosine2 = 1.0 - sine * sine;
  precise float outline = radius * exactInverseSqrt(max(cosine2, 0.05));
  return outline;
}

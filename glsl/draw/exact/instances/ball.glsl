// Balls in perspective and orthographic views: pixel bounds and intersection with rays. Compiles as GLSL and as C++.
#include "common/exact.glsl"

struct Ball {
  vec3 middle;  // vector from the eye to the ball's centre (m)
  float depth;  // depth of the ball's centre along the view direction (m)
  float radius;
};

struct BallHit {
  bool found;
  float depth;
  vec3 outwards;  // vector from the ball's centre to the hit point (m)
};

FUNCTION Ball ballAt(vec3 p, float radius, vec3 eye, vec3 forward) {
  precise vec3 middle = p - eye;
  Ball ball;
  ball.middle = middle;
  ball.depth = exactDot(middle, forward);
  ball.radius = radius;
  return ball;
}

// Returns the hit at the ray parameter `t`. `a` is the vector from the ball's centre to the point of the ray at the
// centre's depth.
FUNCTION BallHit ballHitAfter(Ball ball, vec3 a, vec3 ray, float beyond, float t) {
  precise vec3 outwards = a + ray * t;
  precise float depth = ball.depth + t;
  BallHit hit;
  hit.found = beyond > 0.0f;
  hit.depth = depth;
  hit.outwards = outwards;
  return hit;
}

// Returns the first hit of a ray of depth 1 that starts at the eye. With a = ray * depth - middle, the function solves
// |a + t ray| = radius for t. The vector a is about as short as the ball's radius, so the difference of squares loses
// little precision.
FUNCTION BallHit ballHit(Ball ball, vec3 ray) {
  precise vec3 a = ray * ball.depth - ball.middle;
  float rr = exactDot(ray, ray), b = exactDot(a, ray), aa = exactDot(a, a);
  precise float beyond = b * b - rr * (aa - ball.radius * ball.radius);
  precise float t = -(b + exactSqrt(max(beyond, 0.0f))) * exactReciprocal(rr);
  return ballHitAfter(ball, a, ray, beyond, t);
}

// Returns the hit of a parallel ray that starts at eye + `aside` and has the unit direction `forward`. Here a = aside +
// forward * depth - middle.
FUNCTION BallHit ballHitAlong(Ball ball, vec3 aside, vec3 forward) {
  precise vec3 a = aside + forward * ball.depth - ball.middle;
  float b = exactDot(a, forward), aa = exactDot(a, a);
  precise float beyond = b * b - (aa - ball.radius * ball.radius);
  precise float t = -(b + exactSqrt(max(beyond, 0.0f)));
  return ballHitAfter(ball, a, forward, beyond, t);
}

// Returns the range of pixels along one picture axis that a ball covers in an orthographic view. If the ball covers
// none, first > second. `along` is the vector of that axis in pixels per metre.
FUNCTION vec2 ballSpanAlong(Ball ball, vec3 along, float size) {
  precise float middle = exactDot(ball.middle, along) + 0.5f * size;
  precise float half_ = ball.radius * exactSqrt(exactDot(along, along));
  precise float more = half_ + 0.01f + 1e-5f * (abs(middle) + half_);
  precise float from = middle - more;
  precise float to = middle + more;
  if (to < 0.0f || from > size) return vec2(1.0f, -1.0f);
  return vec2(max(from, 0.0f), min(to, size));
}

// Returns the depth at which the ray hits the disc around the ball's centre that faces the eye.
FUNCTION float discDepth(Ball ball, vec3 ray) {
  float along = exactDot(ray, ball.middle);
  precise float depth = exactDot(ball.middle, ball.middle) * exactReciprocal(max(along, 1e-6f));
  return depth;
}

// Returns the range of pixels along one picture axis that a ball may cover in a perspective view. If the ball covers
// none, first > second. The range ends at the tangent planes through the eye. For a ball with the depth D and
// X = middle . along, these are the positions q with |X - q D| = radius |along - q forward|, where `along` is pixels
// times depth per metre. A ball close to the eye may cover the whole axis unless it is beyond a side of the picture.
FUNCTION vec2 ballSpan(Ball ball, vec3 along, vec3 forward, float size) {
  float x = exactDot(ball.middle, along), aa = exactDot(along, along), af = exactDot(along, forward);
  precise vec3 last = along - forward * size;
  precise float low = x + ball.radius * exactSqrt(aa);
  precise float high = x - size * ball.depth - ball.radius * exactSqrt(exactDot(last, last));
  if (low < 0.0f || high > 0.0f) return vec2(1.0f, -1.0f);
  precise float near_ = 1.0625f * ball.radius;
  if (ball.depth <= near_) return vec2(0.0f, size);
  precise float rr = ball.radius * ball.radius;
  precise float square = ball.depth * ball.depth - rr;
  float perSquare = exactReciprocal(square);
  precise vec3 aside = along * ball.depth - forward * x;
  precise float beyond = exactDot(aside, aside) - rr * (aa - af * af);
  precise float middle = (x * ball.depth - rr * af) * perSquare;
  precise float half_ = ball.radius * exactSqrt(max(beyond, 0.0f)) * perSquare;
  precise float more = half_ + 0.01f + 1e-5f * (abs(middle) + half_);  // margin for rounding errors
  precise float from = middle - more;
  precise float to = middle + more;
  return vec2(max(from, 0.0f), min(to, size));
}

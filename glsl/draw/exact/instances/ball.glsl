// Balls seen from the eye: which pixels they may reach, and where a ray meets them. Compiles as GLSL and as C++.
#include "common/exact.glsl"

struct Ball {
  vec3 middle;  // from the eye (m)
  float depth;  // of the middle, along the direction of the view (m)
  float radius;
};

struct BallHit {
  bool found;
  float depth;
  vec3 outwards;  // from the middle to the place (m)
};

FUNCTION Ball ballAt(vec3 p, float radius, vec3 eye, vec3 forward) {
  precise vec3 middle = p - eye;
  Ball ball;
  ball.middle = middle;
  ball.depth = exactDot(middle, forward);
  ball.radius = radius;
  return ball;
}

// At `t` along a ray that is `a` from the middle where it is as deep as that.
FUNCTION BallHit ballHitAfter(Ball ball, vec3 a, vec3 ray, float beyond, float t) {
  precise vec3 outwards = a + ray * t;
  precise float depth = ball.depth + t;
  BallHit hit;
  hit.found = beyond > 0.0f;
  hit.depth = depth;
  hit.outwards = outwards;
  return hit;
}

// Where a ray of depth 1 from the eye first meets the ball. With a = ray depth - middle, |a + t ray| = radius: the numbers
// are no larger than the ball, so little is lost in the differences of their squares.
FUNCTION BallHit ballHit(Ball ball, vec3 ray) {
  precise vec3 a = ray * ball.depth - ball.middle;
  float rr = exactDot(ray, ray), b = exactDot(a, ray), aa = exactDot(a, a);
  precise float beyond = b * b - rr * (aa - ball.radius * ball.radius);
  precise float t = -(b + exactSqrt(max(beyond, 0.0f))) * exactReciprocal(rr);
  return ballHitAfter(ball, a, ray, beyond, t);
}

// The same of a ray that begins at `aside` from the eye and goes along `forward` (unit): with a = aside + forward depth - middle.
FUNCTION BallHit ballHitAlong(Ball ball, vec3 aside, vec3 forward) {
  precise vec3 a = aside + forward * ball.depth - ball.middle;
  float b = exactDot(a, forward), aa = exactDot(a, a);
  precise float beyond = b * b - (aa - ball.radius * ball.radius);
  precise float t = -(b + exactSqrt(max(beyond, 0.0f)));
  return ballHitAfter(ball, a, forward, beyond, t);
}

// From and to where such rays meet it along one axis of the picture (pixels): `along`, the pixels for each metre. From above to where it
// does not.
FUNCTION vec2 ballSpanAlong(Ball ball, vec3 along, float size) {
  precise float middle = exactDot(ball.middle, along) + 0.5f * size;
  precise float half_ = ball.radius * exactSqrt(exactDot(along, along));
  precise float more = half_ + 0.01f + 1e-5f * (abs(middle) + half_);
  precise float from = middle - more;
  precise float to = middle + more;
  if (to < 0.0f || from > size) return vec2(1.0f, -1.0f);
  return vec2(max(from, 0.0f), min(to, size));
}

// Where that ray meets the disc through the middle that faces the eye.
FUNCTION float discDepth(Ball ball, vec3 ray) {
  float along = exactDot(ray, ball.middle);
  precise float depth = exactDot(ball.middle, ball.middle) * exactReciprocal(max(along, 1e-6f));
  return depth;
}

// From and to where the ball may be seen along one axis of the picture (pixels); from above to where it is not.
//
// Its tangent planes through the eye: with `along` the pixels times depth for each metre, a place x where X - x D =
// radius |along - x forward|. Close to the eye it may be anywhere that no side of the picture excludes.
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
  precise float more = half_ + 0.01f + 1e-5f * (abs(middle) + half_);  // for what is lost by rounding
  precise float from = middle - more;
  precise float to = middle + more;
  return vec2(max(from, 0.0f), min(to, size));
}

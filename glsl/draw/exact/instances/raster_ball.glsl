// Rasterizes balls with one ray per sample. Defines: as for visible_sample.glsl.
#include "draw/exact/visible_sample.glsl"
#include "draw/exact/triangles/triangle.glsl"
#include "draw/exact/instances/ball_source.glsl"
#include "draw/exact/instances/rays.glsl"

// Returns the rectangle (first pixel, last pixel) of the pixels that the ball may cover. If none exist, last <
// first.
ivec4 pixelsOfBall(Ball ball) {
  precise float farthest = ball.depth + ball.radius;
  if (!(ball.radius > 0.0f) || farthest < view.near) return ivec4(0, 0, -1, -1);
  vec2 x = spanOf(ball, view.across.xyz, view.size.x);
  vec2 y = spanOf(ball, view.down.xyz, view.size.y);
  if (x.x > x.y || y.x > y.y) return ivec4(0, 0, -1, -1);
  ivec2 last = min(ivec2(int(floor(x.y)), int(floor(y.y))), ivec2(view.size.x, view.rows.y) - 1);
  return ivec4(int(floor(x.x)), max(int(floor(y.x)), view.rows.x), last);
}

Rays raysOfView() {
  return Rays(view.ray.xyz, view.rayAcross.xyz, view.rayDown.xyz);
}

// Writes the samples of one pixel that the ball covers.
void putBall(Ball ball, Rays rays, ivec2 pixel, uint id) {
  for (int s = 0; s < SAMPLES; ++s) {
    precise vec2 place = vec2(pixel * 16 + samplePlace(s)) * 0.0625f;
    BallHit hit = hitOf(ball, rayAt(rays, place));
#ifdef LAMP_MAP
    // In lamp maps, a ball is a disc through its centre that faces the lamp. The lit half of the ball lies in front of
    // the disc, so the ball does not shadow itself.
    hit.depth = discDepth(ball, rayAt(rays, place));
#endif
    float near = nearOf(hit.depth);
    if (!hit.found || hit.depth < view.near || near < view.nearOverFar) continue;
    int at = sampleIndex(pixel, s);
    keep(at, nearKey(near), keyAt(at), id);
  }
}

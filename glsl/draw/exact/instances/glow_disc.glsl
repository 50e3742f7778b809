// Glows in the picture. A small glow is a disc in the picture plane. A large glow is a disc in space that faces the
// eye, so that the camera can fly through it. BALL: the glow is an additive sphere of uniform light instead.
#include "draw/exact/instances/ball_source.glsl"
#include "draw/exact/instances/glow_add.glsl"
#include "draw/exact/instances/disc.glsl"
#include "draw/exact/instances/rays.glsl"
#include "draw/instances/instance_list.glsl"
#include "draw/exact/haze.glsl"
uniform float roundPixels;  // radius in pixels above which a glow is a disc in space; if 0, every glow is a disc in
                            // space

struct GlowDisc {
  vec3 light;
  Ball ball;
  Disc disc;   // the glow as a disc in the picture (pixels); valid if round_
  float near;  // nearness of the disc (near plane / depth); valid if round_
  bool round_;
  ivec4 box;   // bounding box in pixels: first and last pixel
};

bool farEnough(float depth, float near) {
  return depth >= view.near && near >= view.nearOverFar;
}

// Clips a pixel rectangle to the current band of picture rows.
ivec4 inBand(ivec4 box) {
  return ivec4(box.x, max(box.y, view.rows.x), box.z, min(box.w, view.rows.y - 1));
}

GlowDisc glowDiscOf(int number) {
  vec4 position = texelFetch(positions, number), velocity = texelFetch(velocities, number);
  GlowDisc glow;
  glow.box = ivec4(0, 0, -1, -1);
  glow.ball = ballOf(position, velocity);
  Ball ball = glow.ball;
  if (!(ball.radius > 0.0f)) return glow;
  precise vec2 middle = vec2(exactDot(ball.middle, view.across.xyz), exactDot(ball.middle, view.down.xyz));
#ifdef PARALLEL
  middle = middle + 0.5f * vec2(view.size);
#else
  middle = middle * exactReciprocal(max(ball.depth, 1e-6f));
#endif
  float near = nearOf(ball.depth);
  glow.disc.middle = middle;
  glow.disc.radius = pixelsOf(position.xyz, ball.radius);
  glow.near = near;
#ifdef BALL
  glow.round_ = false;
  precise vec3 light = tintOf(position, velocity) * brightnessAt(velocity.w);
  glow.light = light;
#else
  glow.round_ = farEnough(ball.depth, near) && glow.disc.radius <= roundPixels;
  glow.light = glowOf(position, velocity).light;
#endif
#ifdef HAZE
  precise vec3 dimmed = glow.light * passed(hazeBefore(position.xyz));
  glow.light = dimmed;
#endif
  if (!(isNumber(glow.light.r) && isNumber(glow.light.g) && isNumber(glow.light.b))) return glow;
  if (glow.round_) {
    glow.box = inBand(pixelsOfDisc(glow.disc, view.size));
    return glow;
  }
  precise float farthest = ball.depth + ball.radius;
  if (farthest < view.near) return glow;
  vec2 x = spanOf(ball, view.across.xyz, view.size.x);
  vec2 y = spanOf(ball, view.down.xyz, view.size.y);
  if (x.x > x.y || y.x > y.y) return glow;
  ivec2 last = min(ivec2(int(floor(x.y)), int(floor(y.y))), view.size - 1);
  glow.box = inBand(ivec4(int(floor(x.x)), int(floor(y.x)), last));
  return glow;
}

#ifdef BALL
void addGlow(GlowDisc glow, Rays rays, ivec2 pixel) {
  int at = firstSample(pixel), samples = 0;
  for (int s = 0; s < SAMPLES; ++s) {
    precise vec2 place = vec2(pixel * 16 + samplePlace(s)) * 0.0625f;
    BallHit hit = hitOf(glow.ball, rayAt(rays, place));
    float near = nearOf(hit.depth);
    bool seen = hit.found && farEnough(hit.depth, near) && nearKey(near) < keyAt(at + s);
    samples += seen ? 1 : 0;
  }
  addPart(pixel, glow.light, 1.0f, samples);
}
#else
// Adds the glow's light to a pixel, multiplied by (1 - (distance / radius)^2)^2.
void addGlow(GlowDisc glow, Rays rays, ivec2 pixel) {
  float perRadius = exactReciprocal(glow.round_ ? glow.disc.radius : glow.ball.radius);
  precise vec2 place = vec2(pixel) + 0.5f;
  vec3 ray = rayAt(rays, place), middle = glow.ball.middle;
  // The disc is perpendicular to the vector m from the eye to its centre, so the ray hits it at the depth (m . m) / (m
  // . ray).
#ifdef PARALLEL
  const float towards = 1.0f;
  float depth = glow.ball.depth;
#else
  float towards = exactDot(ray, middle);
  precise float depth = exactDot(middle, middle) * exactReciprocal(max(towards, 1e-12f));
#endif
  precise vec3 off = (alongRay(ray, depth) - middle) * perRadius;
  precise float onPicture = squareFromMiddle(glow.disc, pixel) * perRadius * perRadius;
  float nearInSpace = nearOf(depth);
  float square = glow.round_ ? onPicture : exactDot(off, off);
  float near = glow.round_ ? glow.near : nearInSpace;
  if (square >= 1.0f || (!glow.round_ && (towards <= 0.0f || !farEnough(depth, near)))) return;
  precise float inside = (1.0f - square) * (1.0f - square);
  addPart(pixel, glow.light, inside, samplesBefore(pixel, near));
}
#endif

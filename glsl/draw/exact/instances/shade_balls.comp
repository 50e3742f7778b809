// Shades balls tile by tile. Each ball in a pixel is shaded once: at the pixel's centre if the ball covers it, else at
// the first sample that shows the ball. Balls of a few pixels would twinkle. They are therefore shaded at the four
// corners of a square with the area of their outline, like the driver's small sprites
// (draw/instances/small_sprites.comp). Defines: SAMPLES, SHADOW (with SHADOW_TAPS), OCCLUSION, REFLECTED (not for balls
// of a few pixels), RAYS, and the defines of draw/surface/lighting.glsl.
#define EXACT_PICTURE
#include "common/once.glsl"
#include "draw/exact/tiles/lit_tile.glsl"
#include "draw/exact/instances/ball_source.glsl"
#include "draw/exact/instances/rays.glsl"
#include "draw/instances/instance_list.glsl"
#include "draw/surface/facing.glsl"
#include "draw/exact/occlusion/openness_read.glsl"
#include "draw/exact/reflections/reflections_read.glsl"
#include "draw/surface/lighting.glsl"
#include "draw/exact/haze.glsl"
#ifdef SHADOW
#include "draw/exact/shadows/sun_map.glsl"
#endif
#ifdef RAYS
#include "draw/exact/rays/spots.glsl"
#endif
uniform vec3 material;  // material values: roughness, metallic, translucency
vec3 material_ = once(material);
uniform float squarePixels;  // max radius (pixels) of balls that are shaded as squares
float squarePixels_ = once(squarePixels);

// The point of a ball that is shaded for a pixel or sample.
struct Place {
  vec3 outwards;  // vector from the ball's centre to the shaded point (m)
  vec3 ray;
};

Place placeOn(Ball ball, ivec2 pixel, int firstSample) {
  Rays rays = Rays(view.ray.xyz, view.rayAcross.xyz, view.rayDown.xyz);
  vec3 ray = rayAt(rays, shadingPlace(pixel, -1));
  BallHit hit = hitOf(ball, ray);
  if (!hit.found || hit.depth < view.near) {
    ray = rayAt(rays, shadingPlace(pixel, firstSample));
    hit = hitOf(ball, ray);
  }
  return Place(hit.outwards, ray);
}

// Returns the bilinear weight, at the pixel's centre, of a corner of the square (each coordinate -1 or 1). `perHalf` is
// 1 / half the square's side.
float weightOf(Ball ball, Facing facing, vec2 corner, float perHalf, ivec2 pixel) {
  Rays rays = Rays(view.ray.xyz, view.rayAcross.xyz, view.rayDown.xyz);
  precise vec3 aside = alongRay(rayAt(rays, shadingPlace(pixel, -1)), ball.depth) - ball.middle;
  precise vec2 at = vec2(exactDot(aside, facing.right), exactDot(aside, facing.up)) * perHalf;
  precise vec2 along = 0.5f + 0.5f * clamp(at, vec2(-1.0f), vec2(1.0f)) * corner;
  precise float weight = along.x * along.y;
  return weight;
}

vec4 lightOf(ivec2 pixel, uint slot, int sampleAt) {
  int number = int(slot);
  vec4 position = texelFetch(positions, number), velocity = texelFetch(velocities, number);
  Ball ball = ballOf(position, velocity);
  bool small = pixelRadius(position.xyz, ball.radius) <= squarePixels_;
#ifdef RAYS
  Place seen = placeOn(ball, pixel, sampleAt);
  precise vec3 onBall = position.xyz + seen.outwards;
  vec3 outwards = unitOf(seen.outwards);
  keepSpot(firstSample(pixel) + sampleAt, onBall, outwards, outwards, tintOf(position, velocity), material_, 1.0f);
#ifdef HAZE
  return vec4(throughHaze(vec3(0.0f), 1.0f, onBall), 1.0f);
#else
  return vec4(0.0f, 0.0f, 0.0f, 1.0f);
#endif
#endif
  Facing facing = facingEye(position.xyz);
  Place place = placeOn(ball, pixel, sampleAt);
  precise vec3 backwards = -directionOf(place.ray);
  vec3 towards = small ? facing.towards : unitOf(backwards);
  precise vec3 middle = 0.6666667f * facing.towards;  // mean visible normal: the mean cosine between a ball's visible
                                                      // normals and the view is 2/3
  precise vec3 lit = position.xyz + (small ? ball.radius * middle : place.outwards);
#if defined SHADOW && !defined REFLECTED
  // The shadow is looked up with the sun's direction as normal, because a ball's normals already darken its unlit half.
  float fraction = sunFractionOn(lit, frame.sunDirection.xyz);
#else
  const float fraction = 1.0f;
#endif
  vec3 tint = tintOf(position, velocity);
  Look look = Look(tint, material_.x, material_.y, material_.z, opennessOn(pixel, lit));
  precise float perHalf = 1.1283792f * exactReciprocal(ball.radius);
  vec3 firstNormal = unitOf(place.outwards);
#ifdef REFLECTED
  facing_ = firstNormal;
  // Width of a half-resolution pixel on the ball (m). The width grows where the surface turns away from the view.
  precise vec3 aside = lit - view.eye.xyz;
#ifdef PARALLEL
  const float depth = 1.0f;
#else
  float depth = exactDot(view.forward.xyz, aside);
#endif
  precise float wide = 2.0f * depth * exactSqrt(exactDot(view.rayAcross.xyz, view.rayAcross.xyz));
  precise float along = ball.radius * max(exactDot(firstNormal, towards), 0.05f);
  precise float turn = wide * exactReciprocal(along);
  turns_ = turn;
  vec3 change = vec3(0.0f);
  IF_ANY(!small) change = allLight(look, lit, firstNormal, towards, fraction);
#ifdef HAZE
  change = throughHaze(change, 0.0f, lit);
#endif
  return vec4(change, 0.0f);
#endif
  precise vec3 light = vec3(0.0f);
  int corners = small ? 4 : 1;
  for (int i = 0; i < corners; ++i) {
    vec2 corner = vec2(float((i & 1) * 2 - 1), float((i & 2) - 1));
    precise vec3 side = middle + 0.5270463f * (corner.x * facing.right + corner.y * facing.up);
    vec3 normal = small ? side : firstNormal;
    float weight = small ? weightOf(ball, facing, corner, perHalf, pixel) : 1.0f;
    precise vec3 p = position.xyz + (small ? ball.radius * side : place.outwards);
    light = light + weight * allLight(look, p, normal, towards, fraction);
  }
#ifdef HAZE
  light = throughHaze(light, 1.0f, lit);
#endif
  return vec4(light, 1.0f);
}

#ifdef REFLECTED
uint partOfThing(uint number) {
  return number - firstId_;
}
#endif

void main() {
  lightTile(firstId_, uint(capacity_));
}

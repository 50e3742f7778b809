// Prepares sprites of a few pixels for drawing. GLOW: additive sprites. FOR_LIGHT: sprites in the sun's shadow map.
// Otherwise: lit balls, which become squares with the area of the ball's outline, shaded at four normals.
#include "draw/frame_block.glsl"
#include "draw/instances/instance_list.glsl"
#include "draw/instances/small_sprite.glsl"
#ifndef GLOW
#include "draw/surface/light_map.glsl"
#endif
#if !defined(GLOW) && !defined(FOR_LIGHT)
#include "draw/surface/facing.glsl"
#include "draw/surface/material.glsl"
#include "draw/surface/shadow_read.glsl"
#endif
layout(local_size_x = 64) in;
layout(std430, binding = spriteBinding) writeonly restrict buffer SpriteBlock { uvec4 sprites[]; };
uniform int invocations;

const float squareSide = 1.7724539;  // sqrt(pi), the side of the square with the area of a unit disc

vec3 placed(vec3 p) {
  vec4 clip = clipPlace(p);
  precise vec3 place = clip.xyz * exactReciprocal(clip.w);
  return place;
}

#if defined(FOR_LIGHT)
SmallSprite ready(vec4 position, vec4 velocity) {
  precise float side = squareSide * instanceRadius(position.w) * exactReciprocal(shadowTexel());
  precise vec3 place = shadowPlace(position.xyz) * 2.0 - 1.0;
  return SmallSprite(place, side, vec3(0), vec2(0));
}
#elif defined(GLOW)
SmallSprite ready(vec4 position, vec4 velocity) {
  Glow glow = glowOf(position, velocity);
  precise float side = 2.0 * pixelsOf(glow.middle, glow.radius);
  return SmallSprite(placed(glow.middle), side, glow.light, vec2(0));
}
#else
SmallSprite ready(vec4 position, vec4 velocity) {
  Facing facing = facingEye(position.xyz);
  float radius = max(instanceRadius(position.w), minRadius(position.xyz));
  precise float side = squareSide * pixelsOf(position.xyz, outlineRadius(radius, facing.distance));
  // The mean cosine between the normals of the visible half of a ball and the view direction is 2/3.
  precise vec3 middle = 0.6666667 * facing.towards;
  vec3 tint = tintOf(position, velocity);
  precise vec3 lifted = position.xyz + radius * middle + shadowLift(frame.sunDirection.xyz);
  float fraction = sunFraction(shadowPlace(lifted));
  vec3 light[4];
  for (int i = 0; i < 4; ++i) {
    precise vec3 aside = float((i & 1) * 2 - 1) * facing.right + float((i & 2) - 1) * facing.up;
    precise vec3 normal = middle + 0.5270463 * aside;
    precise vec3 p = position.xyz + radius * normal;
    light[i] = allLight(lookOf(tint), p, normal, facing.towards, fraction);
  }
  precise vec3 mean = 0.25 * (light[0] + light[1] + light[2] + light[3]);
  precise vec3 across = 0.25 * (light[1] - light[0] + light[3] - light[2]);
  precise vec3 upwards = 0.25 * (light[2] - light[0] + light[3] - light[1]);
  precise float whole = mean.r + mean.g + mean.b;
  precise vec2 gained = vec2(across.r + across.g + across.b, upwards.r + upwards.g + upwards.b);
  precise vec2 slope = gained * exactReciprocal(max(whole, 1e-9));
  return SmallSprite(placed(position.xyz), side, mean, slope);
}
#endif

void main() {
  uint count = texelFetch(arguments, level * 8 + 6).x;
  for (uint at = gl_GlobalInvocationID.x; at < count; at += uint(invocations)) {
    vec4 position, velocity;
    listed(at, position, velocity);
    sprites[at] = packedSprite(ready(position, velocity));
  }
}

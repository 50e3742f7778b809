// Instances of a shape. Indices are copy << vertexBits | vertex: drivers are slow at many instances of few
// triangles, so one drawn instance holds `batch` copies. Variants: SPRITE (a square facing the eye, or the sun),
// ADDITIVE, DEPTH_ONLY (into the light's map), SHADOW.
#include "draw/frame_block.glsl"
#include "draw/instance.glsl"
#include "draw/light_map.glsl"
layout(binding = 7) uniform samplerBuffer shape;  // position and normal of each vertex
layout(binding = 8) uniform usamplerBuffer list;
layout(binding = 9) uniform usamplerBuffer arguments;
layout(binding = 10) uniform samplerBuffer stops;
uniform int level;
uniform int batch;
uniform int vertexBits;
uniform bool alongVelocity;
uniform int colorBy;  // sim::Instances::ColorBy
uniform int stopCount;
uniform vec3 color;
uniform vec2 colorScale;  // value * x + y is 0 to 1 over the range
uniform vec2 glow;        // x brightness, y share of life to fade in and out
flat out vec3 tint;
#ifdef SPRITE
out vec3 across;        // from the middle, in radii
flat out vec3 towards;  // the eye
#else
out vec3 worldNormal;
#endif
#ifndef DEPTH_ONLY
out vec3 worldPosition;
#ifdef SHADOW
out vec3 place;
#endif
#endif

vec3 tintOf(vec4 position, vec4 velocity) {
  if (colorBy == 0) return color;
  float value = colorBy == 1 ? length(velocity.xyz) : colorBy == 2 ? position.w : velocity.w;
  float at = clamp(value * colorScale.x + colorScale.y, 0.0, 1.0) * float(stopCount - 1);
  int below = min(int(at), max(stopCount - 2, 0));
  return mix(texelFetch(stops, below).rgb, texelFetch(stops, min(below + 1, stopCount - 1)).rgb, at - float(below));
}

// Brightens and dims over the life; an age of exactly 0 does not age.
float lifeShare(float age) {
  if (glow.y <= 0.0 || age == 0.0) return 1.0;
  float share = clamp(min(age, 1.0 - age) / glow.y, 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

// Columns: the shape's axes. Its z axis lies along the velocity.
mat3 turned(vec3 velocity) {
  float speed = dot(velocity, velocity);
  if (!alongVelocity || !(speed > 1e-20)) return mat3(1);
  vec3 z = velocity * inversesqrt(speed);
  vec3 x = normalize(cross(abs(z.y) < 0.9999 ? vec3(0, 1, 0) : vec3(0, 0, -1), z));
  return mat3(x, cross(z, x), z);
}

void main() {
  int copy = gl_VertexID >> vertexBits, vertex = gl_VertexID & ((1 << vertexBits) - 1);
  uint at = uint(gl_InstanceID * batch + copy);
  gl_Position = vec4(0, 0, 2, 1);  // the last batch's unused copies: one point out of sight
  tint = vec3(0);
#ifdef SPRITE
  across = towards = vec3(0);
#else
  worldNormal = vec3(0);
#endif
#ifndef DEPTH_ONLY
  worldPosition = vec3(0);
#ifdef SHADOW
  place = vec3(0);
#endif
#endif
  if (at >= texelFetch(arguments, level * 8 + 6).x) return;
  int slot = int(texelFetch(list, int(texelFetch(arguments, level * 8 + 5).x + at)).x);
  vec4 position = texelFetch(positions, slot);
  vec4 velocity = texelFetch(velocities, slot);
  float scale = instanceSize(position.w);
#ifdef SPRITE
  float radius = scale * shapeRadius;
  vec2 corner = vec2((vertex & 1) != 0 ? 1 : -1, (vertex & 2) != 0 ? 1 : -1);
#ifdef DEPTH_ONLY
  across = corner.x * frame.lightRight.xyz + corner.y * frame.lightUp.xyz;
#else
  vec3 toEye = frame.eye.xyz - position.xyz;
  float distance = max(length(toEye), 1e-6);
  towards = toEye / distance;
  vec3 right = normalize(cross(frame.rayUp.xyz, towards));
  across = corner.x * right + corner.y * cross(towards, right);
  float least = leastRadius(position.xyz);
#ifdef ADDITIVE
  // Small glows keep their light: a wider one is dimmer by the ratio of areas.
  float share = min(radius / max(least, 1e-12), 1.0);
  tint = tintOf(position, velocity) * (glow.x * lifeShare(velocity.w) * share * share);
#else
  tint = tintOf(position, velocity);
  // The outline of a ball seen from nearby, where the square through its middle meets it.
  radius *= inversesqrt(max(1.0 - radius * radius / (distance * distance), 0.05));
#endif
  radius = max(radius, least);
#endif
  vec3 world = position.xyz + radius * across;
  vec3 lifted = world + frame.sunDirection.xyz * radius;  // above the ball, so it does not shade itself
#else
  mat3 axes = turned(velocity.xyz);
  vec3 world = position.xyz + axes * (scale * texelFetch(shape, vertex * 2).xyz);
  worldNormal = axes * texelFetch(shape, vertex * 2 + 1).xyz;
  vec3 lifted = world + shadowLift(worldNormal);
  tint = tintOf(position, velocity);
#ifdef ADDITIVE
  tint *= glow.x * lifeShare(velocity.w);
#endif
#endif
#ifdef DEPTH_ONLY
  gl_Position = vec4(shadowPlace(world) * 2.0 - 1.0, 1.0);
#else
  worldPosition = world;
#ifdef SHADOW
  place = shadowPlace(lifted);
#endif
  gl_Position = frame.viewProjection * vec4(world, 1.0);
#endif
}

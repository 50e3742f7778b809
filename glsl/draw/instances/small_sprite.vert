// Draws the small sprites that small_sprites.comp prepared, as points. If the driver rounds point sizes (software
// drivers), draws squares. FOR_LIGHT: draws into the sun's shadow map.
#include "draw/bindings.glsl"
#include "draw/instances/small_sprite.glsl"
layout(binding = spriteUnit) uniform usamplerBuffer sprites;
layout(binding = argumentUnit) uniform usamplerBuffer arguments;
uniform int level;
uniform int batch;
uniform int vertexBits;
uniform vec2 targetSize;  // size of the target in pixels
#ifndef FOR_LIGHT
flat out vec3 light;
flat out vec2 slope;
#endif
#ifndef POINT
out vec2 across;
#endif

void main() {
  uint at = uint(gl_InstanceID * batch + (gl_VertexID >> vertexBits));
  bool used = at < texelFetch(arguments, level * 8 + 6).x;
  SmallSprite s = unpackedSprite(texelFetch(sprites, used ? int(at) : 0));
#ifndef FOR_LIGHT
  light = s.light;
  slope = s.slope;
#endif
#ifdef POINT
  gl_PointSize = s.side;
#ifdef FOR_LIGHT
  // Drops a point smaller than a texel unless its square contains the texel's centre, because drivers draw points at
  // least as large as a texel.
  vec2 aside = abs(fract((s.place.xy * 0.5 + 0.5) * targetSize) - 0.5);
  used = used && (s.side >= 1.0 || max(aside.x, aside.y) <= 0.5 * s.side);
#endif
#else
  int corner = gl_VertexID & ((1 << vertexBits) - 1);
  across = vec2((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1);
  s.place.xy += across * s.side / targetSize;
#endif
  gl_Position = used ? vec4(s.place, 1.0) : vec4(0, 0, 2, 1);
}

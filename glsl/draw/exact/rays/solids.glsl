// Reads the triangles of the whole scene in world space, by index, and their bounding boxes. BALLS: reads balls
// instead.
#include "draw/exact/rays/bindings.glsl"
#include "common/exact.glsl"
#ifdef BALLS
// Centre and radius of each ball (m); the radius is 0 for hidden balls.
layout(binding = solidPlaceUnit) uniform samplerBuffer places;

struct Solid {
  vec4 ball;
  vec3 low, high;
  bool there;
};
Solid solidOf(int i) {
  vec4 ball = texelFetch(places, i);
  precise vec3 low = ball.xyz - ball.w;
  precise vec3 high = ball.xyz + ball.w;
  return Solid(ball, low, high, ball.w > 0.0f);
}
#else
layout(binding = solidPlaceUnit) uniform samplerBuffer places;     // position of each vertex (m); w is 0 for invalid
                                                                   // vertices
layout(binding = solidCornerUnit) uniform usamplerBuffer corners;  // three vertex indices per triangle

struct Solid {
  vec4 a, b, c;
  vec3 low, high;
  bool there;
};
Solid solidOf(int i) {
  vec4 a = texelFetch(places, int(texelFetch(corners, 3 * i).x));
  vec4 b = texelFetch(places, int(texelFetch(corners, 3 * i + 1).x));
  vec4 c = texelFetch(places, int(texelFetch(corners, 3 * i + 2).x));
  return Solid(a, b, c, min(a.xyz, min(b.xyz, c.xyz)), max(a.xyz, max(b.xyz, c.xyz)), min(a.w, min(b.w, c.w)) > 0.0f);
}
#endif

// Traverses the hierarchies of triangles (TRIANGLES) and balls (BALLS). ANY_HIT: the traversal ends at the first hit
// that casts a shadow.
#include "draw/exact/rays/ray_shapes.glsl"
#include "draw/exact/rays/hits.glsl"

#ifdef ANY_HIT
#define WALK_OVER(best) best.t <= 0.0f
RayHit taken(RayHit hit, RayHit best, uint flag) {
  bool counts = hit.at != best.at && (flag >> 31) == 0u;
  return RayHit(counts ? 0.0f : best.t, counts ? hit.at : best.at, best.weight);
}
#else
#define WALK_OVER(best) false
RayHit taken(RayHit hit, RayHit best, uint flag) {
  return hit;
}
#endif

#include "draw/exact/rays/walk.glsl"

#ifdef TRIANGLES
#ifdef PASSAGES
#include "draw/exact/rays/passing.glsl"
#else
layout(binding = solidUnit) uniform usamplerBuffer sortedSolids;
#endif
layout(binding = solidNodeUnit) uniform usamplerBuffer solidNodes;

RayHit testTriangle(Ray ray, RayPlanes planes, RayHit best, int i) {
  uvec4 a = texelFetch(sortedSolids, 3 * i), b = texelFetch(sortedSolids, 3 * i + 1), c = texelFetch(sortedSolids, 3 * i + 2);
  vec2 span = spanIn(planes, a.w, b.w, c.w);
  RayHit hit = nearerTriangle(ray, uintBitsToFloat(a.xyz), uintBitsToFloat(b.xyz), uintBitsToFloat(c.xyz), span, i, best);
#ifdef PASSAGES
  // Uses a loop of at most one iteration instead of a branch, so that software drivers skip the closer test if no ray
  // needs it.
  for (bool closer = hit.at != best.at && (a.w & 0x80008000u) == 0x8000u; closer; closer = false) hit = hitOrPassed(ray, hit, best);
#endif
  return taken(hit, best, a.w);
}
WALK(walkTriangles, solidNodes, testTriangle)
#endif

#ifdef BALLS
layout(binding = ballUnit) uniform usamplerBuffer sortedBalls;
layout(binding = ballNodeUnit) uniform usamplerBuffer ballNodes;

RayHit testBall(Ray ray, RayPlanes planes, RayHit best, int i) {
  uvec4 ball = texelFetch(sortedBalls, 2 * i), box = texelFetch(sortedBalls, 2 * i + 1);
  vec2 span = spanIn(planes, box.x, box.y, box.z);
  vec4 shape = uintBitsToFloat(ball);
  RayHit hit = nearerBall(ray, shape.xyz, shape.w, span, i | ballBit, best);
  return taken(hit, best, box.x);
}
WALK(walkBalls, ballNodes, testBall)
#endif

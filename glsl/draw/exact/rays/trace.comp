// Traces rays, one per invocation.
// A ray has two texels: origin and an unused number; unit direction and length (m; 0: no ray). The result has four
// words: the distance, the index of the hit object, and the weights of the triangle's second and third corner. The
// index refers to the triangle order; -1 means no hit; with ballBit, it refers to the ball order; groundHit means the
// ground.
// ANY_HIT: the result is the transmitted fraction of light (x; with PASSAGES rgb) instead, and objects that cast no
// shadow are ignored.
// GOES_ON: only listed rays are traced. LISTED: the rays are in two lists whose lengths are in a buffer. Defines:
// TRIANGLES, BALLS, GROUND; PASSAGES, LAID.
#define EXACT_PICTURE
#include "draw/frame_block.glsl"
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/rays/grid_block.glsl"
#include "draw/exact/rays/traverse.glsl"
#include "draw/exact/rays/ground_ray.glsl"
layout(local_size_x = 64) in;
layout(binding = rayUnit) uniform samplerBuffer rays;
layout(std430, binding = outHitBinding) writeonly restrict buffer HitBlock { uvec4 hits[]; };
uniform int solidCount, solidLeaves, ballCount, ballLeaves;
int solidCount_ = once(solidCount), solidLeaves_ = once(solidLeaves), ballCount_ = once(ballCount), ballLeaves_ = once(ballLeaves);
uniform int firstRay;
uniform int rayCount;
#if defined GOES_ON || defined LISTED
layout(binding = rayListUnit) uniform usamplerBuffer goingOn;
#endif
#ifdef LISTED
layout(std430, binding = outCountBinding) readonly restrict buffer RayListCountBlock { uint counters[2]; };
#endif

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
#ifdef LISTED  // The rays come from two lists. The second list starts at firstRay.
  int first = int(counters[0]);
  if (i >= first + int(counters[1])) return;
  i = int(texelFetch(goingOn, i < first ? i : firstRay + i - first).x);
#else
  if (i >= rayCount) return;
#ifdef GOES_ON
  i = int(texelFetch(goingOn, i).x);
#endif
  i += firstRay;
#endif
  vec4 from = texelFetch(rays, 2 * i), towards = texelFetch(rays, 2 * i + 1);
  Ray ray = rayOf(from.xyz, towards.xyz);
  RayPlanes planes = rayPlanes(gridOfAll(), from.xyz, towards.xyz);
  RayHit best = RayHit(towards.w, -1, vec2(0));
#ifdef ANY_HIT
  precise float open = 1.0f;
#ifdef GROUND
  float ground = groundAlong(from.xyz, towards.xyz);
  bool met = ground > 0.0f && ground < towards.w;
  open = met ? 1.0f - groundAlpha(placeAlong(from.xyz, towards.xyz, ground)) : 1.0f;
  best.t = open > 0.0f ? best.t : 0.0f;
#endif
#ifdef TRIANGLES
  best = walkTriangles(ray, planes, best, solidCount_, solidLeaves_);
#endif
#ifdef BALLS
  best = walkBalls(ray, planes, best, ballCount_, ballLeaves_);
#endif
#if defined PASSAGES && defined TRIANGLES
  precise vec3 passed = lightPassed() * (best.at < 0 ? open : 0.0f);
  hits[i] = uvec4(floatBitsToUint(passed), 0u);
#elif defined PASSAGES
  hits[i] = uvec4(uvec3(floatBitsToUint(best.at < 0 ? open : 0.0f)), 0u);
#else
  hits[i] = uvec4(floatBitsToUint(best.at < 0 ? open : 0.0f), 0u, 0u, 0u);
#endif
#else
#ifdef TRIANGLES
  best = walkTriangles(ray, planes, best, solidCount_, solidLeaves_);
#endif
#ifdef BALLS
  best = walkBalls(ray, planes, best, ballCount_, ballLeaves_);
#endif
#ifdef GROUND
  float ground = groundAlong(from.xyz, towards.xyz);
  bool met = ground > 0.0f && ground < best.t;
  best.t = met ? ground : best.t;
  best.at = met ? groundHit : best.at;
#endif
  hits[i] = uvec4(floatBitsToUint(best.t), uint(best.at), floatBitsToUint(best.weight));
#endif
}

// Continues paths whose ray has hit a clear surface. The ray is reflected or refracted, and the path is listed for the
// next round. One invocation handles one path. GOES_ON: the paths are those that the previous round listed; otherwise,
// all paths. Defines: SAMPLES; LAID and the other material defines.
#define EXACT_PICTURE
#define PATHS_GO_ON
#include "draw/frame_block.glsl"
#include "draw/exact/rays/spot_read.glsl"
#include "draw/exact/rays/facet.glsl"
#include "draw/exact/rays/path_rays.glsl"
#include "draw/exact/rays/ground_ray.glsl"
#include "draw/exact/rays/found_facet.glsl"
#include "draw/exact/rays/ray_width.glsl"
#include "draw/exact/haze.glsl"
layout(local_size_x = 64) in;
layout(binding = rayHitUnit) uniform usamplerBuffer rayHits;
#ifdef GOES_ON
layout(binding = rayListUnit) uniform usamplerBuffer goingOn;
#endif
layout(std430, binding = outListBinding) writeonly restrict buffer NextBlock { uint next[]; };
layout(std430, binding = outCountBinding) restrict buffer CountBlock { uint listed; };
uniform int going;  // number of paths in this round
uniform int round_;

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i >= going) return;
#ifdef GOES_ON
  int path = int(texelFetch(goingOn, i).x);
#else
  int path = i;
#endif
  int ray = onwardKind * paths + path;
  vec4 from = outRays[2 * ray], towards = outRays[2 * ray + 1], weight = rayLight[ray];
  uvec4 hit = texelFetch(rayHits, ray);
  int at = int(hit.y);
  if (towards.w <= 0.0f || at < 0 || at >= ballBit) return;
  ivec3 vertices = metCorners(at);
  if (lookOf(ownerOf(vertices), sheenLook).w <= 0.0f) return;
  float t = uintBitsToFloat(hit.x);
  vec3 p = placeAlong(from.xyz, towards.xyz, t);
#ifdef HAZE
  precise vec3 way = towards.xyz * t;
  float passes = passed(hazeBehind(from.xyz, way));
  precise vec3 ofHaze = weight.rgb * hazeInMirror(towards.xyz) * (1.0f - passes);
  precise vec3 kept = weight.rgb * passes;
  weight.rgb = kept;
#endif
  Found found = foundTriangle(at, p, towards.xyz, t, uintBitsToFloat(hit.zw), 0.0f, rayWidth(from.xyz, t, weight.w));
  Facet f = glassFacet(found.facet, found.owner, found.base, found.metallic, found.inside);
  PathStart start = pathStart(path);
  vec3 u = samplePoint(start.number, sampleMask, start.seed, uint(5 + round_));
  if (u.z >= f.glass) return;  // the path ends here, at the opaque fraction of the surface
  precise float own = u.z * exactReciprocal(f.glass);
  bool byCoat = own < f.coats;  // true for the coat's fraction of the clear part; bounce.comp shades the coat over the
                                // opaque part
  precise float rest = 1.0f - f.coats;
  precise float after = (own - f.coats) * exactReciprocal(rest);
  own = f.coats > 0.0f ? after : own;
  Onward onward;
  if (byCoat) onward = coatOnward(f, u.xy);
  else onward = clearOnward(f, vec3(u.xy, clamp(own, 0.0f, 0.999999f)));
#ifdef HAZE
  int sure = nextSure * paths + path;
  precise vec3 carried = rayLight[sure].rgb + ofHaze;
  rayLight[sure] = vec4(carried, 0.0f);
#endif
  precise vec3 absorbed = lookOf(found.owner, absorbLook).xyz * t;
  vec3 left = f.inside ? vec3(exactExp(-absorbed.x), exactExp(-absorbed.y), exactExp(-absorbed.z)) : vec3(1);
  precise vec3 counts = weight.rgb * onward.weight * left;
  // Through a clear spot, the path may show the sun. At other spots, shadow rays, which pass straight through clear
  // surfaces, already bring the sun's light.
  bool shows = lookOf(int(texelFetch(spots, 4 * start.at + 3).x & 0x7fffffffu), sheenLook).w > 0.0f && weight.w > 0.0f;
  outRays[2 * ray] = vec4(beginning(f, onward.direction), from.w);
  outRays[2 * ray + 1] = vec4(onward.direction, farAway);
  rayLight[ray] = vec4(counts, shows ? surely : 0.0f);
  next[atomicAdd(listed, 1u)] = uint(path);
}

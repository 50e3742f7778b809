// What a ray has met, as shading needs it. TRIANGLES, BALLS, GROUND.
#include "draw/exact/rays/rounded_place.glsl"
#ifdef TRIANGLES
layout(binding = solidUnit) uniform usamplerBuffer sortedSolids;
layout(binding = solidIdUnit) uniform usamplerBuffer solidIds;
layout(binding = solidCornerUnit) uniform usamplerBuffer corners;
layout(binding = solidWordUnit) uniform usamplerBuffer vertexWords;
#endif
#ifdef BALLS
layout(binding = ballUnit) uniform usamplerBuffer sortedBalls;
layout(binding = ballLookUnit) uniform samplerBuffer ballLooks;
#endif
layout(binding = rayLookUnit) uniform samplerBuffer looks;  // roughness, metallic, translucency, whether it casts shadows

#ifdef TRIANGLES
vec3 colorOf(uvec4 words) {
  return vec3(unpackHalf2x16(words.y), unpackHalf2x16(words.z).x);
}
Facet foundTriangle(int at, vec3 p, vec3 along, float t, vec2 weight, float least) {
  int id = int(texelFetch(solidIds, at).x);
  uvec4 a = texelFetch(vertexWords, int(texelFetch(corners, 3 * id).x));
  uvec4 b = texelFetch(vertexWords, int(texelFetch(corners, 3 * id + 1).x));
  uvec4 c = texelFetch(vertexWords, int(texelFetch(corners, 3 * id + 2).x));
  vec3 pa = uintBitsToFloat(texelFetch(sortedSolids, 3 * at).xyz), pb = uintBitsToFloat(texelFetch(sortedSolids, 3 * at + 1).xyz);
  vec3 pc = uintBitsToFloat(texelFetch(sortedSolids, 3 * at + 2).xyz);
  precise vec3 first = pb - pa;
  precise vec3 second = pc - pa;
  vec3 across = exactCross(first, second);
  precise float square = max(exactDot(across, across), 1e-30f);
  precise vec3 facing = across * exactInverseSqrt(square);
  precise vec3 view = -along;
  facing = exactDot(facing, view) < 0.0f ? -facing : facing;
  vec3 na = unpackedUnit(a.x), nb = unpackedUnit(b.x), nc = unpackedUnit(c.x);
  precise float rest = 1.0f - weight.x - weight.y;
  precise vec3 mean = na * rest + nb * weight.x + nc * weight.y;
  bool turned = exactDot(mean, facing) < 0.0f;
  vec3 normal = unitOf(turned ? -mean : mean);
  precise vec3 base = colorOf(a) * rest + colorOf(b) * weight.x + colorOf(c) * weight.y;
  vec4 look = texelFetch(looks, int(a.w));
  vec3 lifted = roundedPlace(p, pa, pb, pc, turned ? -na : na, turned ? -nb : nb, turned ? -nc : nc, vec3(rest, weight));
  return facetOf(lifted, facing, normal, view, base, vec3(max(look.x, least), look.yz), t);
}
#endif

#ifdef BALLS
Facet foundBall(int at, vec3 p, vec3 along, float t, float least) {
  vec4 ball = uintBitsToFloat(texelFetch(sortedBalls, 2 * at));
  vec4 own = texelFetch(ballLooks, int(texelFetch(sortedBalls, 2 * at + 1).w));
  precise vec3 outwards = p - ball.xyz;
  vec3 normal = unitOf(outwards);
  precise vec3 view = -along;
  vec4 look = texelFetch(looks, int(own.w));
  return facetOf(p, normal, normal, view, own.rgb, vec3(max(look.x, least), look.yz), t);
}
#endif

// `least`: roughness that it has at least.
Facet foundFacet(int at, vec3 p, vec3 along, float t, vec2 weight, float least) {
#ifdef BALLS
  if (at >= ballBit && at != groundHit) return foundBall(at - ballBit, p, along, t, least);
#endif
#ifdef TRIANGLES
  if (at < ballBit) return foundTriangle(at, p, along, t, weight, least);
#endif
  precise vec3 view = -along;
  return facetOf(p, vec3(0, 1, 0), vec3(0, 1, 0), view, frame.groundColor.rgb, vec3(max(frame.groundRoughness, least), 0.0f, 0.0f), t);
}

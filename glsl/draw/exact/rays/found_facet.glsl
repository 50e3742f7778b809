// Computes the shading point (facet) where a ray hits the scene. TRIANGLES, BALLS, GROUND: the scene has these objects.
// LAID: materials have textures (maps) or skins (laid_on.glsl). RAISED: the texture adds a relief. SKINS: some surfaces
// have skins. EMITTERS: facets may emit light. FINISHED: facets may have a coat or fibres, or transmit light
// (facet.glsl).
#include "draw/exact/rays/rounded_place.glsl"
#include "draw/exact/rays/looks.glsl"
#ifdef TRIANGLES
#include "draw/exact/rays/met_triangle.glsl"
#endif
#ifdef BALLS
layout(binding = ballUnit) uniform usamplerBuffer sortedBalls;
layout(binding = ballLookUnit) uniform samplerBuffer ballLooks;
#endif
#ifdef LAID
#include "draw/exact/rays/laid_on.glsl"
#endif

#ifdef FINISHED
#include "draw/exact/rays/finished_look.glsl"
#endif

struct Found {
  Facet facet;
  int owner;
  vec3 base;
  float metallic;
  bool inside;
  vec3 smooth_;
};

#ifdef TRIANGLES
vec3 colorOf(uvec4 words) {
  return vec3(unpackHalf2x16(words.y), unpackHalf2x16(words.z).x);
}
Found foundTriangle(int at, vec3 p, vec3 along, float t, vec2 weight, float minimum, float width) {
  ivec3 vertices = metCorners(at);
  uvec4 a = texelFetch(vertexWords, vertices.x), b = texelFetch(vertexWords, vertices.y), c = texelFetch(vertexWords, vertices.z);
  vec3 pa = metPlace(at, 0), pb = metPlace(at, 1), pc = metPlace(at, 2);
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
  vec4 look = lookOf(int(a.w), fallbackMaterial);
  vec3 lifted = roundedPlace(p, pa, pb, pc, turned ? -na : na, turned ? -nb : nb, turned ? -nc : nc, vec3(rest, weight));
  Found found;
  found.owner = int(a.w);
  found.inside = turned;
  found.smooth_ = normal;
#ifdef EMITTERS
  vec3 emission = lookOf(found.owner, lightLook).rgb;
#endif
#ifdef LAID
  Laid laid = laidAt(found.owner, vertices, pa, pb, pc, vec3(rest, weight), facing, turned ? -normal : normal, width);
  ivec4 colorMap = ivec4(lookWords(found.owner, colorMapLook)), normalMap = ivec4(lookWords(found.owner, normalMapLook));
  ivec4 metalRoughMap = ivec4(lookWords(found.owner, metalRoughMapLook));
  if (colorMap.x > 0) base = base * mapLaid(laid, colorMap).rgb;
  if (metalRoughMap.x > 0) {
    vec4 made = mapLaid(laid, metalRoughMap);
    precise float rough = look.x * made.g;
    precise float metal = look.y * made.b;
    look.x = rough;
    look.y = metal;
  }
  if (normalMap.x > 0) {
    LaidNormal relief = normalLaid(found.owner, laid, turned ? -normal : normal, normalMap);
    normal = turned ? -relief.normal : relief.normal;
    look.x = spreadRoughness(look.x, relief.mean);
  }
#ifdef RAISED
  normal = normalRaised(laid, normal, colorMap, lookOf(found.owner, glassLook).z);
#endif
#ifdef EMITTERS
  ivec4 emissionMap = ivec4(lookWords(found.owner, emissionMapLook));
  if (emissionMap.x > 0) {
    precise vec3 part = emission * mapLaid(laid, emissionMap).rgb;
    emission = part;
  }
#endif
#ifdef SKINS
  if (takeSkin(found.owner)) {
    HitSkin grown = skinLaid(found.owner, laid, normal);
    normal = grown.normal;
    base = grown.skin.albedo;
    look.x = grown.skin.roughness;
#ifdef EMITTERS
    emission = grown.skin.emission;
#endif
  }
#endif
#endif
  found.base = base;
  found.metallic = look.y;
#ifdef FINISHED
  lifted = lookOf(found.owner, sheenLook).w > 0.0f ? p : lifted;
#endif
  found.facet = facetOf(lifted, facing, normal, view, base, vec3(max(look.x, minimum), look.yz), t);
  precise vec3 moved = lifted - p;
  found.facet.lift = exactDot(moved, facing);
#ifdef EMITTERS
  found.facet.emission = emission;
  found.facet.sought = lookOf(found.owner, lightLook).rgb;
#endif
#ifdef FINISHED
  found.facet = finishedFacet(found.facet, found.owner, found.smooth_);
#endif
  return found;
}
#endif

#ifdef BALLS
Facet foundBall(int at, vec3 p, vec3 along, float t, float minimum) {
  vec4 ball = uintBitsToFloat(texelFetch(sortedBalls, 2 * at));
  vec4 own = texelFetch(ballLooks, int(texelFetch(sortedBalls, 2 * at + 1).w));
  precise vec3 outwards = p - ball.xyz;
  vec3 normal = unitOf(outwards);
  precise vec3 view = -along;
  vec4 look = lookOf(int(own.w), fallbackMaterial);
  return facetOf(p, normal, normal, view, own.rgb, vec3(max(look.x, minimum), look.yz), t);
}
#endif

// Returns the facet of a hit. `minimum` is the minimum roughness of the facet. `width` is the filter width of textures
// (m).
Facet foundFacet(int at, vec3 p, vec3 along, float t, vec2 weight, float minimum, float width) {
#ifdef BALLS
  if (at >= ballBit && at != groundHit) return foundBall(at - ballBit, p, along, t, minimum);
#endif
#ifdef TRIANGLES
  if (at < ballBit) {
    Facet f = foundTriangle(at, p, along, t, weight, minimum, width).facet;
#ifdef FINISHED
    f = settled(f);
#endif
    return f;
  }
#endif
  precise vec3 view = -along;
  return facetOf(p, vec3(0, 1, 0), vec3(0, 1, 0), view, frame.groundColor.rgb, vec3(max(frame.groundRoughness, minimum), 0.0f, 0.0f), t);
}

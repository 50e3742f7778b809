// Where light that meets a clear surface goes on, mirrored or through it: by a facet of a GGX surface, as often as Fresnel's equations
// say (Walter et al., "Microfacet models for refraction through rough surfaces", EGSR 2007, with facets as they are seen, so that what counts
// is what the others leave in the open). Part of facet.glsl.
const float surely = 1e9f;  // density of what no other sample finds (1/sr)

FUNCTION Onward clearOnward(Facet f, vec3 u) {
  vec3 facet = unitOf(facetSeen(f.normal, f.nv, f.alpha, f.view, u.x, u.y));
  float cosine = clamp(exactDot(f.view, facet), 0.0f, 1.0f);
  float mirrored = clearFresnel(f, cosine);
  bool mirror = u.z < mirrored;
  precise vec3 back = facet * (2.0f * cosine) - f.view;
  // A sheet's second side turns what goes through back, as rough as a mirror image of it.
  precise vec3 behind = back - f.normal * (2.0f * exactDot(f.normal, back));
  vec3 bent = refractedDirection(f.view, facet, etaOf(f));
  vec3 direction = mirror ? back : f.thin ? behind : bent;
  // What shading alone turns to the wrong side comes back.
  float side = exactDot(f.facing, direction);
  float wrong = (mirror ? side < 0.0f : side > 0.0f) ? side : 0.0f;
  precise vec3 turned_ = direction - f.facing * (2.0f * wrong);
  direction = unitOf(turned_);
  float nl = abs(exactDot(f.normal, direction));
  float seen = ggxLambda(f.nv, f.alpha), lit = ggxLambda(max(nl, 1e-3f), f.alpha);
  precise float one = 1.0f + seen;
  precise float both = 1.0f + seen + lit;
  precise float beyond = 1.0f + lit;
  precise float open = mirror ? one * exactReciprocal(both) : exactReciprocal(beyond);
  precise float often = (1.0f - f.coats) * f.glass;
  precise float share = f.clear * exactReciprocal(max(often, 1e-6f)) * open;
  precise vec3 weight = (mirror ? vec3(1.0f) : f.tint) * share;
  Onward onward;
  onward.direction = direction;
  onward.weight = weight;
  onward.density = mirror && !f.inside ? lobeTowards(f, direction).clearDensity : surely;
  onward.share = 1.0f;
  onward.roughness = f.roughness;
  return onward;
}

// Where light that meets a coat over a clear surface goes on, mirrored by the coat's lobe: as facetOf() and finishedLobes() have it,
// over how often samples take the lobe, of which `coats` is another factor.
FUNCTION Onward coatOnward(Facet f, vec2 u) {
  vec3 facet = unitOf(facetSeen(f.coatNormal, f.coatNv, f.coatAlpha, f.view, u.x, u.y));
  float cosine = clamp(exactDot(f.view, facet), 0.0f, 1.0f);
  precise vec3 mirrored = facet * (2.0f * cosine) - f.view;
  float nl = exactDot(f.coatNormal, mirrored);
  float seen = ggxLambda(f.coatNv, f.coatAlpha), lit = ggxLambda(max(nl, 1e-3f), f.coatAlpha);
  precise float one = 1.0f + seen;
  precise float both = 1.0f + seen + lit;
  precise vec3 weight = fresnel(vec3(0.04f), cosine) * (f.coat * one * exactReciprocal(both) * exactReciprocal(max(f.coats, 1e-6f)));
  float wrong = min(exactDot(f.facing, mirrored), 0.0f);
  precise vec3 outside = mirrored - f.facing * (2.0f * wrong);
  Onward onward;
  onward.direction = unitOf(outside);
  onward.weight = nl > 0.0f ? weight : vec3(0.0f);
  onward.density = surely;
  onward.share = 1.0f;
  onward.roughness = exactSqrt(f.coatAlpha);
  return onward;
}

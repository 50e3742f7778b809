// Samples the direction in which light continues at a clear (transmissive) surface. Light is reflected or refracted at
// a microfacet of a GGX surface, with the probabilities of Fresnel's equations (Walter et al., "Microfacet models for
// refraction through rough surfaces", EGSR 2007). The microfacets are sampled from those visible from the view
// direction, so the weight is only the other masking term. Part of facet.glsl.
const float surely = 1e9f;  // density (1/sr) for directions that only this sampling method finds

FUNCTION Onward clearOnward(Facet f, vec3 u) {
  vec3 facet = unitOf(facetSeen(f.normal, f.nv, f.alpha, f.view, u.x, u.y));
  float cosine = clamp(exactDot(f.view, facet), 0.0f, 1.0f);
  float mirrored = clearFresnel(f, cosine);
  bool mirror = u.z < mirrored;
  precise vec3 back = facet * (2.0f * cosine) - f.view;
  // The second side of a thin sheet bends transmitted light back. The transmitted direction is the mirror image of the
  // reflected one and equally rough.
  precise vec3 behind = back - f.normal * (2.0f * exactDot(f.normal, back));
  vec3 bent = refractedDirection(f.view, facet, etaOf(f));
  vec3 direction = mirror ? back : f.thin ? behind : bent;
  // Mirrors the direction back if it is on the wrong side of the geometric surface only because of the shading normal.
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

// Samples the direction in which light continues if the coat over a clear surface reflects it. The weight is the coat's
// light, as in facetOf() and finishedLobes(), divided by the probability of the coat's lobe. This probability includes
// the factor `coats`.
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

// A facet is a shading point of the path tracer with its reflection model. A GGX lobe lies over a diffuse surface,
// which receives the light that the lobe does not reflect. Light is irradiance / pi, as in draw/surface/shading.glsl.
// EMITTERS: the facet may emit light. FINISHED: the facet may have a coat and fibres on top and may transmit light
// (finished_facet.glsl). Compiles as GLSL and as C++.
#ifndef EXACT_RAY_FACET
#define EXACT_RAY_FACET
#include "draw/surface/shading.glsl"
#include "draw/exact/rays/directions.glsl"
#ifdef FINISHED
#include "draw/exact/rays/dielectric.glsl"
#include "draw/surface/sheen.glsl"
#endif

struct Facet {
  vec3 place;
  vec3 facing;  // unit geometric normal that points to the viewer's side
  vec3 normal;
  vec3 view;    // unit vector to the viewer
  vec3 matt;    // diffuse colour
  vec3 f0;
  float roughness;
  float alpha;
  float translucency;
  float off;    // offset (m) of ray origins from the surface
  float lift;   // height (m) of the rounded position above the flat triangle (rounded_place.glsl)
  float nv;     // cosine between normal and view, above 0
  float mirrors;  // probability that a sample continues with the GGX lobe
#ifdef EMITTERS
  vec3 emission;
  vec3 sought;  // emission as emitter sampling assumes it: without the emission map; 0 for skins
#endif
#ifdef FINISHED
  float kept;  // fraction of the light of lobe and diffuse surface that coat and fibres let through
  float coat;  // strength of the coat
  vec3 coatNormal;
  float coatAlpha;
  float coatNv;
  float coats;  // probability that a sample continues with the coat's lobe
  vec3 fibres;
  float fibreRoughness;
  float glass;   // fraction of the light for which the clear (transmissive) surface replaces lobe and diffuse surface
  float clear;   // fraction of the clear surface, reduced by the losses in coat and fibres
  float clearF0;
  float ior;
  vec3 tint;
  bool thin;
  bool inside;   // true if the viewer is inside the solid
#endif
};

FUNCTION float brightnessOf(vec3 c) {
  precise float b = 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
  return b;
}

// Returns a facet. `material` holds roughness, metallic and translucency. `reach` is the distance from the viewer (m).
FUNCTION Facet facetOf(vec3 place, vec3 facing, vec3 normal, vec3 view, vec3 base, vec3 material, float reach) {
  Facet f;
  f.place = place;
  f.view = view;
  f.facing = exactDot(facing, view) < 0.0f ? -facing : facing;
  // If the shading normal points away from the viewer, bends it back just far enough.
  float seen = exactDot(normal, view);
  precise float missing = 0.02f - seen;
  precise vec3 bent = normal + view * max(missing, 0.0f);
  f.normal = unitOf(bent);
  f.nv = clamp(exactDot(f.normal, view), 1e-3f, 1.0f);
  f.roughness = material.x;
  f.alpha = roughAlpha(material.x);
  f.translucency = material.z;
  f.f0 = blend(vec3(0.04f), base, material.y);
  vec2 lobed = ambientLobe(material.x, f.nv);
  precise float lost = 0.04f * lobed.x + lobed.y;
  precise float kept = 1.0f - clamp(lost, 0.0f, 1.0f);
  precise vec3 matt = base * ((1.0f - material.y) * kept);
  f.matt = matt;
  precise vec3 mirrored = f.f0 * lobed.x + lobed.y;
  float lobeShare = max(brightnessOf(mirrored), 1e-4f), mattShare = max(brightnessOf(matt), 0.0f);
  precise float all_ = lobeShare + mattShare;
  // The lobe has a min probability. At grazing angles it reflects much more than its mean, and rare samples would be
  // noisy.
  precise float likely = lobeShare * exactReciprocal(all_);
  f.mirrors = mattShare > 0.0f ? max(likely, 0.2f) : 1.0f;
  float largest = max(abs(place.x), max(abs(place.y), abs(place.z)));
  precise float off = 1e-5f * max(largest, reach);
  f.off = off;
  f.lift = 0.0f;
#ifdef EMITTERS
  f.emission = f.sought = vec3(0.0f);
#endif
#ifdef FINISHED
  f.kept = 1.0f;
  f.coat = f.coats = f.glass = f.clear = f.clearF0 = 0.0f;
  f.coatNormal = f.normal;
  f.coatAlpha = f.alpha;
  f.coatNv = f.nv;
  f.fibres = vec3(0.0f);
  f.fibreRoughness = 0.5f;
  f.ior = 1.5f;
  f.tint = vec3(1.0f);
  f.thin = f.inside = false;
#endif
  return f;
}

// Returns the cosine factor of the diffuse surface, including light that comes through from behind (translucency).
FUNCTION float mattCosine(Facet f, float nl) {
  float lit = max(nl, 0.0f);
  precise float direct = lit + (max(-nl, 0.0f) - lit) * f.translucency;
  return direct;
}

// Returns the origin of a ray in the given direction. The origin is above the visible side, or below the flat triangle
// for transmitted light.
FUNCTION vec3 beginning(Facet f, vec3 direction) {
  bool lets = f.translucency > 0.0f;
#ifdef FINISHED
  lets = lets || f.glass > 0.0f;
#endif
  bool through = lets && exactDot(f.facing, direction) < 0.0f;
  precise float below = -f.off - f.lift;
  precise vec3 p = f.place + f.facing * (through ? below : f.off);
  return p;
}

// Response of a facet to light from one direction: pi times the lobe's value times the cosine, and the density with
// which the lobe samples the direction.
struct Lobed {
  vec3 light;
  float density;
#ifdef FINISHED
  float coatDensity;
  float roughness;  // roughness of lobe and coat: mean weighted by their light
  vec3 fibres;      // light of the fibres, in the unit of `light`
  float clear;      // light of the clear surface, in the unit of `light`
  float clearDensity;
#endif
};
#ifdef FINISHED
#include "draw/exact/rays/finished_facet.glsl"
#else
// Returns the specular light of lamps and sun, which samples of the lobe cannot hit. `lobed` holds x and y of the
// expression F0 x + y.
FUNCTION vec3 mirroredBy(Facet f, vec2 lobed) {
  precise vec3 mirrored = f.f0 * lobed.x + lobed.y;
  return mirrored;
}
#endif
FUNCTION Lobed lobeTowards(Facet f, vec3 direction) {
  Lobed none;
  none.light = vec3(0.0f);
  none.density = 0.0f;
  float nl = exactDot(f.normal, direction);
  precise vec3 sum = f.view + direction;
  vec3 half_ = unitOf(sum);
  float nh = clamp(exactDot(f.normal, half_), 0.0f, 1.0f), lh = clamp(exactDot(direction, half_), 0.0f, 1.0f);
  float d = ggxDensity(nh, f.alpha), seen = ggxLambda(f.nv, f.alpha), lit = ggxLambda(max(nl, 1e-3f), f.alpha);
  precise float both = 1.0f + seen + lit;
  precise float one = 1.0f + seen;
  precise float quarter = 0.25f * d * exactReciprocal(f.nv);
  precise float density = quarter * exactReciprocal(one);
  precise vec3 light = fresnel(f.f0, lh) * (3.14159265f * quarter * exactReciprocal(both));
#ifdef FINISHED
  none.coatDensity = none.clear = none.clearDensity = 0.0f;
  none.roughness = f.roughness;
  none.fibres = vec3(0.0f);
#endif
  if (nl <= 0.0f) return none;
  Lobed found;
  found.light = light;
  found.density = density;
#ifdef FINISHED
  precise float shape = 3.14159265f * quarter * exactReciprocal(both);
  found = finishedLobes(f, found, direction, lh, shape);
#endif
  return found;
}

// Returns the density (1/sr) with which samples continue in a direction.
FUNCTION float densityTowards(Facet f, Lobed lobed, float nl) {
  precise float matts = 1.0f - f.mirrors;
  precise float density = f.mirrors * lobed.density + matts * mattCosine(f, nl) * 0.31830989f;
#ifdef FINISHED
  precise float of = f.coats * lobed.coatDensity + restOf(f) * density;
  density = of;
#endif
  return density;
}

// Samples the direction in which a path continues, from the lobe or the diffuse surface. The weight is the total
// response of both divided by the total density of both (Veach and Guibas, "Optimally Combining Sampling Techniques",
// SIGGRAPH 1995).
struct Onward {
  vec3 direction;
  vec3 weight;
  float density;  // sample density of the direction (1/sr)
  float share;    // fraction of the response that is due to the lobe
#ifdef FINISHED
  float roughness;
#endif
};
// Returns a unit microfacet normal, sampled with the random numbers u and v from the normals visible from `view`.
// `cosine` is the cosine between `axis` and view.
FUNCTION vec3 facetSeen(vec3 axis, float cosine, float alpha, vec3 view, float u, float v) {
  vec3 right = rightOf(axis), up = upOf(axis);
  vec3 own = vec3(exactDot(right, view), exactDot(up, view), cosine);
  vec3 h = visibleNormal(own, alpha, u, v);
  precise vec3 facet = right * h.x + up * h.y + axis * h.z;
  return facet;
}
#ifdef FINISHED
#include "draw/exact/rays/clear_facet.glsl"
#endif
FUNCTION Onward onwardFrom(Facet f, vec3 u) {
  float pick = u.z;
#ifdef FINISHED
  bool byCoat = pick < f.coats;
  if (!byCoat) {
    precise float clears = (1.0f - f.coats) * f.glass;
    precise float after = pick - f.coats;
    precise float own = after * exactReciprocal(max(clears, 1e-6f));
    precise float left = (after - clears) * exactReciprocal(max(restOf(f), 1e-6f));
    if (after < clears) return clearOnward(f, vec3(u.x, u.y, min(own, 0.999999f)));
    pick = clamp(left, 0.0f, 0.999999f);
  }
#endif
  bool mirror = pick < f.mirrors;
  precise float matts = 1.0f - f.mirrors;
  precise float rest = (pick - f.mirrors) * exactReciprocal(max(matts, 1e-6f));
  bool through = !mirror && rest < f.translucency;
  vec3 axis = f.normal;
  float cosine = f.nv, alpha = f.alpha;
#ifdef FINISHED
  mirror = mirror || byCoat;
  through = through && !byCoat;
  axis = byCoat ? f.coatNormal : axis;
  cosine = byCoat ? f.coatNv : cosine;
  alpha = byCoat ? f.coatAlpha : alpha;
#endif
  vec3 facet = facetSeen(axis, cosine, alpha, f.view, u.x, u.y);
  precise vec3 mirrored = facet * (2.0f * exactDot(f.view, facet)) - f.view;
  vec3 direction = mirror ? mirrored : cosineDirection(through ? -f.normal : f.normal, u.x, u.y);
  // If a direction points into the surface only because of the shading normal, mirrors it back out.
  float side = exactDot(f.facing, direction), shaded = exactDot(f.normal, direction);
  bool turned = through ? side > 0.0f && shaded < 0.0f : side < 0.0f && shaded > 0.0f;
  float away = turned ? side : 0.0f;
  precise vec3 outside = direction - f.facing * (2.0f * away);
  direction = unitOf(outside);
  float nl = exactDot(f.normal, direction);
  Lobed lobed = lobeTowards(f, direction);
  float density = densityTowards(f, lobed, nl);
  precise vec3 ofMatt = f.matt * mattCosine(f, nl);
#ifdef FINISHED
  ofMatt = ofMatt + lobed.fibres;
#endif
  float lobeLight = brightnessOf(lobed.light), mattLight = brightnessOf(ofMatt);
  precise float all_ = lobeLight + mattLight;
  precise float share = lobeLight * exactReciprocal(max(all_, 1e-25f));
  precise vec3 weight = (ofMatt + lobed.light) * (0.31830989f * exactReciprocal(max(density, 1e-12f)));
  Onward onward;
  onward.direction = direction;
  onward.weight = density > 1e-12f ? weight : vec3(0.0f);
  onward.density = density;
  onward.share = share;
#ifdef FINISHED
  onward.roughness = lobed.roughness;
#endif
  return onward;
}
#endif

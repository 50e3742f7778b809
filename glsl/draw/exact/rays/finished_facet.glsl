// Further layers of a facet: fibres (draw/surface/sheen.glsl) over lobe and diffuse surface, a coat (coat.glsl) over
// the fibres, and a clear (transmissive) surface that replaces a fraction of lobe and diffuse surface. Each layer
// receives the light that the layers above let through. Part of facet.glsl.

// Returns the probability that a sample continues with the lobe or the diffuse surface.
FUNCTION float restOf(Facet f) {
  precise float rest = (1.0f - f.coats) * (1.0f - f.glass);
  return rest;
}

FUNCTION Facet withFibres(Facet f, vec3 color, float roughness) {
  float maximum = max(color.x, max(color.y, color.z));
  precise float kept = 1.0f - maximum * sheenAlbedo(roughness, f.nv);
  f.fibres = color;
  f.fibreRoughness = roughness;
  f.kept = max(kept, 0.0f);
  // Samples of the diffuse surface also sample the fibres, so at least half of the samples are diffuse.
  f.mirrors = maximum > 0.0f ? min(f.mirrors, 0.5f) : f.mirrors;
  return f;
}

// Adds a coat. `normal` is the normal that points to the viewer's side, without relief.
FUNCTION Facet withCoat(Facet f, vec3 normal, float strength, float roughness) {
  precise float missing = 0.02f - exactDot(normal, f.view);
  precise vec3 bent = normal + f.view * max(missing, 0.0f);
  f.coatNormal = unitOf(bent);
  f.coatNv = clamp(exactDot(f.coatNormal, f.view), 1e-3f, 1.0f);
  f.coatAlpha = roughAlpha(roughness);
  f.coat = strength;
  vec2 lobed = ambientLobe(roughness, f.coatNv);
  precise float taken = strength * (0.04f * lobed.x + lobed.y);
  precise float left = 1.0f - clamp(taken, 0.0f, 1.0f);
  precise float kept = f.kept * left;
  precise vec3 fibres = f.fibres * left;
  f.kept = kept;
  f.fibres = fibres;
  f.coats = strength > 0.0f ? clamp(taken, 0.2f, 0.8f) : 0.0f;
  return f;
}

// Adds a clear surface. `share` is the fraction of the non-metallic part that is clear. `tint` is the factor on
// transmitted light.
FUNCTION Facet withGlass(Facet f, float share, float metallic, float ior, bool thin, bool inside, vec3 tint) {
  precise float glass = share * (1.0f - metallic);
  precise float clear = f.kept * glass;
  precise float kept = f.kept - clear;
  precise float indices = ior + 1.0f;
  precise float low = (ior - 1.0f) * exactReciprocal(indices);
  precise float f0 = low * low;
  f.glass = glass;
  f.clear = clear;
  f.kept = kept;
  f.clearF0 = f0;
  f.ior = max(ior, 1.0f);
  f.thin = thin;
  f.inside = inside && !thin;
  f.tint = tint;
  return f;
}
// Applies the accumulated losses to the diffuse colour. Must be called after all layers are added.
FUNCTION Facet settled(Facet f) {
  precise vec3 matt = f.matt * f.kept;
  f.matt = matt;
  return f;
}

// Returns the index of refraction on the viewer's side divided by the index on the opposite side.
FUNCTION float etaOf(Facet f) {
  return f.inside ? f.ior : exactReciprocal(f.ior);
}
// Returns the fraction of light that a clear surface reflects at the given cosine. A thin sheet reflects at both sides,
// including all inter-reflections.
FUNCTION float clearFresnel(Facet f, float cosine) {
  float once_ = dielectricFresnel(cosine, etaOf(f));
  precise float all_ = 1.0f + once_;
  precise float both = 2.0f * once_ * exactReciprocal(all_);
  return f.thin ? both : once_;
}

// Returns the specular light of lamps and sun from lobe and clear surface, because samples of the lobes cannot hit
// lamps and sun. Inside a solid, the clear surface reflects no light of lamps and sun.
FUNCTION vec3 mirroredBy(Facet f, vec2 lobed) {
  float clear = f.inside ? 0.0f : f.clear;
  precise vec3 f0 = f.f0 * f.kept + clear * f.clearF0;
  precise vec3 mirrored = f0 * lobed.x + (f.kept + clear) * lobed.y;
  return mirrored;
}
// Returns the light that coat and fibres reflect, for light from `towards`. `coatAlpha` is the alpha of the coat's
// lobe, widened for the size of the light (widenedAlpha()).
FUNCTION vec3 overLight(Facet f, vec3 towards, float coatAlpha) {
  float nl = max(exactDot(f.normal, towards), 0.0f), coated_ = max(exactDot(f.coatNormal, towards), 0.0f);
  vec2 lobed = lobe(f.coatNormal, f.view, towards, coatAlpha);
  precise float ofCoat = f.coat * coated_ * (0.04f * lobed.x + lobed.y);
  precise vec3 over = vec3(ofCoat);
  if (max(f.fibres.x, max(f.fibres.y, f.fibres.z)) > 0.0f) over = over + f.fibres * (nl * sheenLobe(f.normal, f.view, towards, f.fibreRoughness));
  return over;
}

// Returns the response of all layers to light from a direction above the surface. `lh` is the cosine between the light
// and the half vector. `shape` is the value of the lobe without the Fresnel term.
FUNCTION Lobed finishedLobes(Facet f, Lobed found, vec3 direction, float lh, float shape) {
  precise vec3 sum = f.view + direction;
  vec3 half_ = unitOf(sum);
  float nl = exactDot(f.normal, direction), coated_ = exactDot(f.coatNormal, direction);
  float nh = clamp(exactDot(f.coatNormal, half_), 0.0f, 1.0f);
  float d = ggxDensity(nh, f.coatAlpha), seen = ggxLambda(f.coatNv, f.coatAlpha), lit = ggxLambda(max(coated_, 1e-3f), f.coatAlpha);
  precise float both = 1.0f + seen + lit;
  precise float one = 1.0f + seen;
  precise float quarter = 0.25f * d * exactReciprocal(f.coatNv);
  precise float coatDensity = quarter * exactReciprocal(one);
  precise vec3 ofCoat = fresnel(vec3(0.04f), lh) * (3.14159265f * quarter * f.coat * exactReciprocal(both));
  bool mirrors = f.coat > 0.0f && coated_ > 0.0f;
  ofCoat = mirrors ? ofCoat : vec3(0.0f);
  found.coatDensity = mirrors ? coatDensity : 0.0f;
  precise vec3 own = found.light * f.kept;
  precise vec3 all_ = own + ofCoat;
  float ownLight = brightnessOf(own), coatLight = brightnessOf(ofCoat);
  precise float lobes = ownLight + coatLight;
  precise float roughness = f.roughness + (exactSqrt(f.coatAlpha) - f.roughness) * coatLight * exactReciprocal(max(lobes, 1e-25f));
  found.light = all_;
  found.roughness = roughness;
  found.fibres = vec3(0.0f);
  if (max(f.fibres.x, max(f.fibres.y, f.fibres.z)) > 0.0f) {
    precise vec3 ofFibres = f.fibres * (max(nl, 0.0f) * sheenLobe(f.normal, f.view, direction, f.fibreRoughness));
    found.fibres = ofFibres;
  }
  float mirrored = clearFresnel(f, lh);
  precise float clear = f.clear * mirrored * shape;
  precise float clearDensity = (1.0f - f.coats) * f.glass * mirrored * found.density;
  found.clear = f.inside ? 0.0f : clear;
  found.clearDensity = f.inside ? 0.0f : clearDensity;
  return found;
}

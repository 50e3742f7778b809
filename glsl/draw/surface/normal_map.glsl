// Normals from a map in tangent space: x along u, y against v, z outwards. Compiles as GLSL and as C++.
#include "draw/surface/rise.glsl"

// Of texels 0 to 1; `strength`: a factor on the slopes. z at least a twentieth, so that none lies in the surface.
FUNCTION vec3 tangentNormal(vec3 texel, float strength) {
  ROUNDED vec3 t = texel * 2.0f - 1.0f;
  ROUNDED vec2 slopes = vec2(t.x, t.y) * strength;
  return vec3(slopes.x, slopes.y, max(t.z, 0.05f));
}

// The frame is the surface's own as it is seen: y against the gradient of v, x across it towards where u grows, as from
// tangents along u and their cross products with the normal (MikkTSpace), but of each place anew. Arguments as of riseByUv.
// Holds for mirrored uvs. A surface without uvs keeps its normal.
FUNCTION vec3 mappedNormal(vec3 t, vec3 normal, vec3 across, vec3 up, vec2 right, vec2 above) {
  vec3 first = crossed(up, normal), second = crossed(normal, across);
  float turned = dotted(across, first) < 0.0f ? -1.0f : 1.0f;
  ROUNDED vec3 u = (first * right.x + second * above.x) * turned;
  ROUNDED vec3 v = (first * right.y + second * above.y) * turned;
  ROUNDED vec3 against = v * -inverseRoot(max(dotted(v, v), 1e-30f));
  vec3 aside = crossed(against, normal);
  float along = dotted(aside, u) < 0.0f ? -1.0f : 1.0f;
  ROUNDED vec3 mapped = t.x * along * aside + t.y * against + t.z * normal;
  return unitOf(mapped);
}

// Roughness of what a pixel shows of a map whose normals differ there: their mean is shorter than each, and what they spread
// widens the lobe, alpha^2 + 2 (1 - length) / length (after Toksvig, "Mipmapping normal maps", 2005). Rounding to bytes
// shortens by less than a hundredth.
FUNCTION float spreadRoughness(float roughness, vec3 texel) {
  ROUNDED vec3 t = texel * 2.0f - 1.0f;
  float length_ = root(min(dotted(t, t), 1.0f));
  ROUNDED float shorter = max(0.99f - length_, 0.0f) * inverse(max(length_, 0.1f));
  ROUNDED float alpha = roughness * roughness;
  ROUNDED float alpha2 = alpha * alpha + 2.0f * shorter;
  return shorter > 0.0f ? min(root(root(alpha2)), 1.0f) : roughness;
}

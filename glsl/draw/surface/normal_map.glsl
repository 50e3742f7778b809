// Normals from a tangent-space normal map. x points along u, y against v, z outwards. Compiles as GLSL and as C++.
#include "draw/surface/rise.glsl"

// Decodes a normal from a texel (0 to 1). `strength` is the factor on the slopes. z is at least 0.05, so that no normal
// is tangential to the surface.
FUNCTION vec3 tangentNormal(vec3 texel, float strength) {
  ROUNDED vec3 t = texel * 2.0f - 1.0f;
  ROUNDED vec2 slopes = vec2(t.x, t.y) * strength;
  return vec3(slopes.x, slopes.y, max(t.z, 0.05f));
}

// Returns the mapped normal in world space. The tangent frame is computed for each pixel: y is opposite to the gradient
// of v; x is perpendicular to y and points towards growing u. The frame equals a MikkTSpace frame with tangents along u
// and bitangents from the cross product with the normal, but it is not interpolated from vertices. `across`, `up`,
// `right` and `above` have the same meaning as in riseByUv(). Works for mirrored uvs. A surface without uvs keeps its
// normal.
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

// Returns the roughness of a pixel in which the map's normals vary. The mean of the normals is shorter than 1, and
// their spread widens the lobe to alpha^2 + 2 (1 - length) / length (after Toksvig, "Mipmapping normal maps", 2005). A
// shortening below 0.01 is ignored, because rounding to bytes may cause it.
FUNCTION float spreadRoughness(float roughness, vec3 texel) {
  ROUNDED vec3 t = texel * 2.0f - 1.0f;
  float length_ = root(min(dotted(t, t), 1.0f));
  ROUNDED float shorter = max(0.99f - length_, 0.0f) * inverse(max(length_, 0.1f));
  ROUNDED float alpha = roughness * roughness;
  ROUNDED float alpha2 = alpha * alpha + 2.0f * shorter;
  return shorter > 0.0f ? min(root(root(alpha2)), 1.0f) : roughness;
}

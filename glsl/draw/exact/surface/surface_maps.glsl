// Reads the material maps at a shading point of a surface (surface_seen.glsl). Defines: BASE_MAP, NORMAL_MAP,
// METAL_ROUGH_MAP, OCCLUSION_MAP, EMISSION_MAP.
#include "draw/exact/surface/map_read.glsl"
#include "draw/surface/normal_map.glsl"
#define MAP(NAME)     \
  uniform ivec4 NAME; \
  ivec4 NAME##_ = once(NAME);
#ifdef BASE_MAP
MAP(colorMap)
#endif
#ifdef METAL_ROUGH_MAP
MAP(metalRoughMap)
#endif
#ifdef OCCLUSION_MAP
MAP(occlusionMap)
uniform float occlusionStrength;
float occlusionStrength_ = once(occlusionStrength);
#endif
#ifdef EMISSION_MAP
MAP(emissionMap)
#endif

#ifdef TRIPLANAR
vec4 mapOn(SurfaceSeen seen, ivec4 map) {
  precise vec4 sum = vec4(0);
  int left = sidesThatShow(seen.weight);
  while (left != 0) {
    int side = findLSB(left);
    left &= left - 1;
    float weight = side == 0 ? seen.weight.x : side == 1 ? seen.weight.y : seen.weight.z;
    sum = sum + mapAt(sideSeen(seen, side), map) * weight;
  }
  return sum;
}
#else
vec4 mapOn(SurfaceSeen seen, ivec4 map) {
  return mapAt(seen, map);
}
#endif

#ifdef OCCLUSION_MAP
float openOn(SurfaceSeen seen) {
  precise float open = 1.0f + occlusionStrength_ * (mapOn(seen, occlusionMap_).r - 1.0f);
  return open;
}
#endif

#ifdef NORMAL_MAP
MAP(normalMap)
uniform float normalStrength;
float normalStrength_ = once(normalStrength);

struct Relief {
  vec3 normal;
  vec3 mean;  // mean of the normal map's texels
};

#ifdef TRIPLANAR
Relief reliefOn(SurfaceSeen seen, Spot spot) {
  vec3 w = seen.weight;
  precise vec3 mean = vec3(0);
  vec2 x = vec2(0), y = vec2(0), z = vec2(0);
  precise float outwards = 0.0f;
  int left = sidesThatShow(w);
  while (left != 0) {
    int side = findLSB(left);
    left &= left - 1;
    float weight = side == 0 ? w.x : side == 1 ? w.y : w.z;
    vec3 texel = mapAt(sideSeen(seen, side), normalMap_).xyz;
    vec3 t = tangentNormal(texel, normalStrength_);
    vec2 rises = vec2(-t.x, t.y);  // slopes of the relief in the map, to the right and downwards
    if (side == 0) x = rises;
    if (side == 1) y = rises;
    if (side == 2) z = rises;
    outwards = outwards + weight * t.z;
    mean = mean + texel * weight;
  }
  vec3 own = riseFromSides(w, seen.side, x, y, z);
  precise vec3 rise = (model_[0].xyz * own.x + model_[1].xyz * own.y + model_[2].xyz * own.z) * exactReciprocal(modelScale_);
  rise = rise - spot.normal * exactDot(spot.normal, rise);
  precise vec3 raised = spot.normal * outwards - rise;
  return Relief(unitOf(raised), mean);
}
#else
Relief reliefOn(SurfaceSeen seen, Spot spot) {
  vec3 texel = mapAt(seen, normalMap_).xyz;
  precise vec3 right = planePlace(spot, vec2(1, 0)) - spot.place;
  precise vec3 above = planePlace(spot, vec2(0, -1)) - spot.place;
  return Relief(mappedNormal(tangentNormal(texel, normalStrength_), spot.normal, right, above, seen.across, seen.up), texel);
}
#endif
#endif

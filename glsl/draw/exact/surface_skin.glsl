// Lays a skin over a spot of a surface: TRIPLANAR from three sides (draw/surface/three_sides.glsl), else by uv.
#include "draw/exact/skin_read.glsl"

struct SpotSkin {
  Skin skin;
  vec3 normal;
};

#ifdef TRIPLANAR
SpotSkin skinOn(Spot spot, vec3 normal) {
  SurfaceSeen seen = surfaceSeen(spot);
  SkinArea x = skinArea(seen.x), y = skinArea(seen.y), z = skinArea(seen.z);
  vec3 w = seen.weight;
  SkinArea area;
  area.q = exactDot(w, vec3(x.q, y.q, z.q));
  area.variance = exactDot(w, vec3(x.variance, y.variance, z.variance));
  area.around = exactDot(w, vec3(x.around, y.around, z.around));
  precise vec3 color = w.x * x.color + w.y * y.color + w.z * z.color;
  area.color = color;
  area.slope = vec2(0);
  precise vec2 change = w.x * changeOver(x, seen.x) + w.y * changeOver(y, seen.y) + w.z * changeOver(z, seen.z);
  precise float change2 = change.x * change.x + change.y * change.y;
  vec3 own = riseFromSides(w, seen.side, x.slope, y.slope, z.slope);
  precise vec3 rise = (model[0].xyz * own.x + model[1].xyz * own.y + model[2].xyz * own.z) * exactReciprocal(modelScale);
  rise = rise - normal * exactDot(normal, rise);
#else
SpotSkin skinOn(Spot spot, vec3 normal) {
  Seen seen = seenByUv(spot, textureScale);
  SkinArea area = skinArea(seen);
  vec2 change = changeOver(area, seen);
  precise float change2 = change.x * change.x + change.y * change.y;
  precise vec3 right = planePlace(spot, vec2(1, 0)) - spot.place;
  precise vec3 above = planePlace(spot, vec2(0, -1)) - spot.place;
  vec2 du = seen.across, dv = seen.up;
  vec3 rise = riseByUv(area.slope, normal, right, above, du, dv);
#endif
  SpotSkin found;
  found.skin = skinOf(area, change2);
  precise vec3 raised = normal - skinDepth * rise;
  found.normal = unitOf(raised);
  return found;
}

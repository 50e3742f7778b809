// Applies a skin at a shading point of a surface. TRIPLANAR: projects the skin along three axes
// (draw/surface/three_sides.glsl) instead of using uv.
#include "draw/exact/surface/skin_read.glsl"

// Field values and gradient over the footprint of a pixel.
struct SkinSeen {
  SkinArea area;
  float change2;  // squared change of q per pixel
  vec3 rise;      // gradient of q along the surface (change per cell)
};

struct SpotSkin {
  Skin skin;
  vec3 normal;
};

#ifdef TRIPLANAR
SkinArea noArea() {
  SkinArea area;
  area.q = area.variance = area.around = 0.0f;
  area.slope = vec2(0);
  area.color = vec3(0);
  return area;
}

SkinSeen skinSeen(Spot spot, vec3 normal) {
  SurfaceSeen seen = surfaceSeen(spot);
  vec3 w = seen.weight;
  // Loops only over the projections with a weight above 0; surface_texture.glsl gives the reason.
  SkinArea x = noArea(), y = noArea(), z = noArea();
  int left = sidesThatShow(w);
  while (left != 0) {
    int side = findLSB(left);
    left &= left - 1;
    SkinArea area = skinArea(sideSeen(seen, side));
    if (side == 0) x = area;
    if (side == 1) y = area;
    if (side == 2) z = area;
  }
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
  precise vec3 rise = (model_[0].xyz * own.x + model_[1].xyz * own.y + model_[2].xyz * own.z) * exactReciprocal(modelScale_);
  rise = rise - normal * exactDot(normal, rise);
  return SkinSeen(area, change2, rise);
}
#else
SkinSeen skinSeen(Spot spot, vec3 normal) {
  Seen seen = seenByUv(spot, textureScale_);
  SkinArea area = skinArea(seen);
  vec2 change = changeOver(area, seen);
  precise float change2 = change.x * change.x + change.y * change.y;
  precise vec3 right = planePlace(spot, vec2(1, 0)) - spot.place;
  precise vec3 above = planePlace(spot, vec2(0, -1)) - spot.place;
  vec2 du = seen.across, dv = seen.up;
  vec3 rise = riseByUv(area.slope, normal, right, above, du, dv);
  return SkinSeen(area, change2, rise);
}
#endif

SpotSkin skinOn(Spot spot, vec3 normal) {
  SkinSeen seen = skinSeen(spot, normal);
  precise vec3 raised = normal - skinDepth * seen.rise;
  return SpotSkin(skinOf(seen.area, seen.change2), unitOf(raised));
}

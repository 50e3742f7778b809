// Applies a skin to a surface, by uv. TRIPLANAR: projects the skin along the three axes of the object space
// (three_sides.glsl) instead.
#include "draw/surface/skin.glsl"
#ifdef TRIPLANAR
uniform vec2 skinRepeats;  // repeats of the skin per metre
uniform mat4 model;
#else
in vec2 uv;
#endif

#ifdef TRIPLANAR
// Returns the field values at this point. `rise` is the gradient of q in world space, per cell.
SkinArea areaOnSurface(vec3 normal, out vec3 rise) {
  ThreeSides three = threeSides(objectPosition, objectNormal);
  vec3 side = three.side, weight = three.weight;
  SkinArea x = skinArea(three.x * skinRepeats), y = skinArea(three.y * skinRepeats), z = skinArea(three.z * skinRepeats);
  SkinArea area;
  area.q = dot(weight, vec3(x.q, y.q, z.q));
  area.variance = dot(weight, vec3(x.variance, y.variance, z.variance));
  area.around = dot(weight, vec3(x.around, y.around, z.around));
  area.color = weight.x * x.color + weight.y * y.color + weight.z * z.color;
  area.slope = vec2(0);
  vec3 own = riseFromSides(weight, side, x.slope, y.slope, z.slope);
  rise = mat3(model) * own * inversesqrt(max(dot(model[0].xyz, model[0].xyz), 1e-30));
  rise -= normal * dot(normal, rise);
  return area;
}
#else
SkinArea areaOnSurface(vec3 normal, out vec3 rise) {
  SkinArea area = skinArea(uv);
  vec2 right = dFdx(uv), up = dFdy(uv);
  rise = riseByUv(area.slope, normal, dFdx(worldPosition), dFdy(worldPosition), right, up);
  return area;
}
#endif

// Returns the skin at this point and tilts the normal by the skin's relief.
Skin skinOnSurface(inout vec3 normal) {
  vec3 rise;
  SkinArea area = areaOnSurface(normal, rise);
  Skin skin = skinOf(area);
  normal = normalize(normal - skinDepth * rise);
  return skin;
}

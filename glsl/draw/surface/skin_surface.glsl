// Lays a skin over a surface. TRIPLANAR: from three sides (three_sides.glsl) in the object's own space, else by uv.
#include "draw/surface/skin.glsl"
#ifdef TRIPLANAR
uniform vec2 skinRepeats;  // copies a metre
uniform mat4 model;
#else
in vec2 uv;
#endif

#ifdef TRIPLANAR
// `rise`: gradient of q in world space, per cell.
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
  vec3 own = weight.x * vec3(0, -x.slope.y, -side.x * x.slope.x) + weight.y * vec3(y.slope.x, 0, side.y * y.slope.y) +
             weight.z * vec3(side.z * z.slope.x, -z.slope.y, 0);
  rise = mat3(model) * own * inversesqrt(max(dot(model[0].xyz, model[0].xyz), 1e-30));
  rise -= normal * dot(normal, rise);
  return area;
}
#else
vec3 unit(vec3 v) {
  return v * inversesqrt(max(dot(v, v), 1e-30));
}

// Directions of growing u and v on the surface from the changes over a pixel (Mikkelsen, "Surface gradient-based
// bump mapping framework", JCGT 9(3), 2020). Holds for mirrored uvs and for both faces.
SkinArea areaOnSurface(vec3 normal, out vec3 rise) {
  SkinArea area = skinArea(uv);
  vec3 across = dFdx(worldPosition), down = dFdy(worldPosition);
  vec3 first = cross(down, normal), second = cross(normal, across);
  float turned = dot(across, first) < 0.0 ? -1.0 : 1.0;
  vec2 du = dFdx(uv), dv = dFdy(uv);
  vec3 alongU = unit(first * du.x + second * dv.x), alongV = unit(first * du.y + second * dv.y);
  rise = turned * (area.slope.x * alongU + area.slope.y * alongV);
  return area;
}
#endif

// The skin at this place; turns the normal.
Skin skinOnSurface(inout vec3 normal) {
  vec3 rise;
  SkinArea area = areaOnSurface(normal, rise);
  Skin skin = skinOf(area);
  normal = normalize(normal - skinDepth * rise);
  return skin;
}

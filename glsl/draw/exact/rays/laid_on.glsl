// Textures (maps) and, with SKINS, skins at a triangle hit, by uv or by triplanar projection. They are filtered over
// the width that the ray represents. Define: LAID.
#include "draw/exact/rays/lays.glsl"
#include "draw/surface/three_sides.glsl"
#include "draw/surface/normal_map.glsl"
#include "draw/surface/raised_normal.glsl"
#include "draw/exact/rays/looks.glsl"

struct Laid {
  Seen x, y, z;   // texture positions and their changes in the three projections; with uv, only x is used
  vec3 weight;
  vec3 side;
  vec3 right;     // changes of the world position for the uv changes `across` and `up`
  vec3 above;
  bool sides;     // true for triplanar projection
};

int laidSides(vec3 weight) {
  return (weight.x > 0.0f ? 1 : 0) | (weight.y > 0.0f ? 2 : 0) | (weight.z > 0.0f ? 4 : 0);
}
Seen laidSide(Laid laid, int side) {
  Seen one = laid.z;
  if (side == 0) one = laid.x;
  if (side == 1) one = laid.y;
  return one;
}
float laidWeight(Laid laid, int side) {
  return side == 0 ? laid.weight.x : side == 1 ? laid.weight.y : laid.weight.z;
}

Seen laidBetween(vec2 at, vec2 right, vec2 above, vec2 repeats) {
  Seen seen;
  precise vec2 here = at * repeats;
  precise vec2 across = (right - at) * repeats;
  precise vec2 up = (above - at) * repeats;
  seen.at = here;
  seen.across = across;
  seen.up = up;
  return seen;
}

// Returns v in the axes of the surface's object space, in metres.
vec3 inOwnSpace(int owner, vec3 v, float scale) {
  vec3 own = vec3(exactDot(lookOf(owner, modelLook).xyz, v), exactDot(lookOf(owner, modelLook + 1).xyz, v), exactDot(lookOf(owner, modelLook + 2).xyz, v));
  precise vec3 turned = own * exactReciprocal(scale);
  return turned;
}
vec3 fromOwnSpace(int owner, vec3 own, float scale) {
  precise vec3 v = (lookOf(owner, modelLook).xyz * own.x + lookOf(owner, modelLook + 1).xyz * own.y + lookOf(owner, modelLook + 2).xyz * own.z) * exactReciprocal(scale);
  return v;
}

// Returns the textures at a hit. a, b and c are the corners of the triangle. `normal` is the unit normal interpolated
// from the corners. `width` is the filter width (m).
Laid laidAt(int owner, ivec3 vertices, vec3 a, vec3 b, vec3 c, vec3 weight, vec3 facing, vec3 normal, float width) {
  vec4 how = lookOf(owner, laidLook);
  vec3 la = texelFetch(lays, vertices.x).xyz, lb = texelFetch(lays, vertices.y).xyz, lc = texelFetch(lays, vertices.z).xyz;
  precise vec3 here = la * weight.x + lb * weight.y + lc * weight.z;
  precise vec3 first = b - a;
  precise vec3 second = c - a;
  float square = max(exactDot(first, first), 1e-30f), perLength = exactInverseSqrt(square);
  precise vec3 along = first * perLength;
  vec3 aside = exactCross(facing, along);
  float reach = exactDot(second, along), height = exactDot(second, aside);
  float perHeight = abs(height) > 1e-20f ? exactReciprocal(height) : 0.0f;
  // Changes of the texture position per metre along the first edge and perpendicular to it.
  precise vec3 change = (lb - la) * perLength;
  precise vec3 changeAside = ((lc - la) - change * reach) * perHeight;
  precise vec3 right = here + change * width;
  precise vec3 above = here + changeAside * width;
  precise vec3 rightPlace = along * width;
  precise vec3 abovePlace = aside * width;
  Laid laid;
  laid.right = rightPlace;
  laid.above = abovePlace;
  laid.sides = how.w > 0.0f;
  laid.side = vec3(1.0f);
  if (laid.sides) {
    vec3 own = inOwnSpace(owner, normal, how.w);
    ThreeSides at = threeSides(here, own), besides = threeSides(right, own), over = threeSides(above, own);
    laid.x = laidBetween(at.x, besides.x, over.x, how.xy);
    laid.y = laidBetween(at.y, besides.y, over.y, how.xy);
    laid.z = laidBetween(at.z, besides.z, over.z, how.xy);
    laid.weight = at.weight;
    laid.side = at.side;
  } else {
    laid.x = laidBetween(here.xy, right.xy, above.xy, how.xy);
    laid.y = laid.z = laid.x;
    laid.weight = vec3(1, 0, 0);
  }
  return laid;
}

vec4 mapLaid(Laid laid, ivec4 map) {
  precise vec4 sum = vec4(0);
  int left = map.x > 0 ? laidSides(laid.weight) : 0;
  while (left != 0) {
    int side = findLSB(left);
    left &= left - 1;
    sum = sum + mapAt(laidSide(laid, side), map) * laidWeight(laid, side);
  }
  return sum;
}

// Returns the gradient of the height in world space, tangential to the surface. x, y and z are the slopes along u and v
// in the three projections.
vec3 riseLaid(int owner, Laid laid, vec3 normal, vec2 x, vec2 y, vec2 z) {
  float scale = lookOf(owner, laidLook).w;
  vec3 own = riseFromSides(laid.weight, laid.side, x, y, z);
  precise vec3 rise = fromOwnSpace(owner, own, max(scale, 1e-20f));
  rise = rise - normal * exactDot(normal, rise);
  return rise;
}

struct LaidNormal {
  vec3 normal;
  vec3 mean;  // mean of the normal map's texels
};
LaidNormal normalLaid(int owner, Laid laid, vec3 normal, ivec4 map) {
  float strength = lookOf(owner, laidLook).z;
  vec2 riseX = vec2(0), riseY = vec2(0), riseZ = vec2(0);
  precise float outwards = 0.0f;
  precise vec3 mean = vec3(0);
  vec3 tangent = vec3(0, 0, 1);
  int left = laidSides(laid.weight);
  while (left != 0) {
    int side = findLSB(left);
    left &= left - 1;
    vec3 texel = mapAt(laidSide(laid, side), map).xyz;
    tangent = tangentNormal(texel, strength);
    vec2 rise = vec2(-tangent.x, tangent.y);
    riseX = side == 0 ? rise : riseX;
    riseY = side == 1 ? rise : riseY;
    riseZ = side == 2 ? rise : riseZ;
    outwards = outwards + laidWeight(laid, side) * tangent.z;
    mean = mean + texel * laidWeight(laid, side);
  }
  if (!laid.sides) return LaidNormal(mappedNormal(tangent, normal, laid.right, laid.above, laid.x.across, laid.x.up), mean);
  precise vec3 raised = normal * outwards - riseLaid(owner, laid, normal, riseX, riseY, riseZ);
  return LaidNormal(unitOf(raised), mean);
}
#ifdef RAISED
// Returns the normal, tilted by a relief whose height is the texture's brightness;
// draw/exact/surface/surface_texture.glsl does the same for pixels. The height difference is taken over the ray's
// width, or over one texel if that is wider. `white` is the height of white (m); `normal` points to the viewer's side.
vec3 normalRaised(Laid laid, vec3 normal, ivec4 map, float white) {
  TextureShape shape = mapShape(map);
  precise float texels = 0.0f;
  int sides = white != 0.0f ? laidSides(laid.weight) : 0, left = sides;
  while (left != 0) {
    int side = findLSB(left);
    left &= left - 1;
    texels = texels + laidWeight(laid, side) * footprintOf(laidSide(laid, side), shape).longer;
  }
  float aside = pixelsAside(texels);
  precise float across = 0.0f;
  precise float up = 0.0f;
  while (sides != 0) {
    int side = findLSB(sides);
    sides &= sides - 1;
    Seen seen = laidSide(laid, side);
    Footprint print = footprintOf(seen, shape);
    precise vec2 right = seen.across * aside;
    precise vec2 above = seen.up * aside;
    // Rounds 0 and 1 sample along `across`, rounds 2 and 3 along `up`. The loop is used because software drivers then
    // compile these texture reads only once.
    for (int i = 0; i < 4; ++i) {
      precise float sign_ = (i & 1) == 0 ? laidWeight(laid, side) : -laidWeight(laid, side);
      precise vec2 end_ = (i & 1) == 0 ? seen.at + (i < 2 ? right : above) : seen.at - (i < 2 ? right : above);
      float height = brightness(mapWithin(end_, print, map).rgb);
      precise float more = sign_ * height;
      across = across + (i < 2 ? more : 0.0f);
      up = up + (i < 2 ? 0.0f : more);
    }
  }
  precise float per = 0.5f * white * exactReciprocal(aside);
  precise vec2 rises = vec2(across, up) * per;
  vec3 raised = raisedNormal(normal, laid.right, laid.above, rises);
  return white != 0.0f ? raised : normal;
}
#endif
#ifdef SKINS
#include "draw/exact/rays/skin_hit.glsl"
#endif

// Returns the fraction of an area light that reaches a point, by the method of sun_disc.glsl. The method applies
// because the nearness on a shadow map face (1 / distance along the face's axis) is affine over a plane, like the depth
// in the sun's map.
#include "draw/exact/shadows/shadow_filter.glsl"
#include "draw/exact/shadows/disc_points.glsl"

struct AreaReceiver {
  vec2 middle;   // position of the receiver on the map in texels
  float near;    // receiver's nearness, relative to the nearest caster: distance of that caster / distance of the
                 // receiver
  vec2 rise;     // change of the receiver's nearness per texel along its surface
  float spread;  // radius of the penumbra (texels) per unit of nearness between caster and receiver
  float minimum;   // min radius of the filter in texels
  float maximum;    // max radius of the filter in texels
};

float mapNear(usamplerBuffer keys, ShadowMap map, vec2 texel) {
  ivec2 at = clamp(ivec2(texel), ivec2(0), ivec2(map.side - 1));
  uint key = texelFetch(keys, map.first + at.y * map.stride + at.x).x;
  return key > nearKey(0.0f) ? -1e30f : intBitsToFloat(int(nearKey(0.0f) - key));
}

// Casters at 128 points spread evenly over a disc: their number and the sum of their nearness.
struct Casters {
  int count;
  float near;
};
Casters castersWithin(usamplerBuffer keys, ShadowMap map, AreaReceiver r, float radius) {
  precise vec2 aside = radius * vec2(0.033f, 0.1f);
  vec2 turned = vec2(-aside.y, aside.x);
  Casters found = Casters(0, 0.0f);
  for (int i = 0; i < 32; ++i) {
    precise vec2 middle = (0.985f * radius) * discPoints[i];
    for (int k = 0; k < 4; ++k) {  // the four corners of a square as large as the spacing of the disc points
      precise vec2 way = middle + ((k & 1) == 0 ? 1.0f : -1.0f) * ((k & 2) == 0 ? aside : turned);
      precise vec2 place = r.middle + way;
      vec2 texel = floor(place);
      precise vec2 centre = (texel + 0.5f) - r.middle;
      precise float plane = r.near + r.rise.x * centre.x + r.rise.y * centre.y;
      float near = mapNear(keys, map, texel);
      bool shades = near > plane;
      precise float sum = found.near + (shades ? near : 0.0f);
      found.near = sum;
      found.count += shades ? 1 : 0;
    }
  }
  return found;
}

float areaDiscFraction(usamplerBuffer keys, ShadowMap map, AreaReceiver r) {
  precise float widest = (1.0f - r.near) * r.spread;
  Casters casters = castersWithin(keys, map, r, clamp(widest, r.minimum, r.maximum));
  if (casters.count == 0) return 1.0f;
  precise float between = casters.near * exactReciprocal(float(casters.count)) - r.near;
  precise float wide = between * r.spread;
  int shaded = castersWithin(keys, map, r, clamp(wide, r.minimum, r.maximum)).count;
  precise float fraction = float(128 - shaded) * 0.0078125f;
  return fraction;
}

// Skins at ray hits, for laid_on.glsl. One buffer holds the texels of all skins. takeSkin() loads the skin parameters
// of one owner into global variables.
layout(binding = raySkinUnit) uniform usamplerBuffer skinTexels;
int skinFirst_ = 0, reliefLevels_ = 1, skinLook_ = 0;
ivec2 reliefSize_ = ivec2(1);
vec2 skinCells_ = vec2(1);
float skinThreshold_ = 0.5f, skinRoughness_ = 1.0f, skinDepth_ = 0.0f;
vec3 skinLow_ = vec3(0), skinHigh_ = vec3(0);
#define SKIN_TAKEN
#include "draw/exact/surface/skin_read.glsl"

bool takeSkin(int owner) {
  uvec4 shape = lookWords(owner, skinLook);
  vec4 values = lookOf(owner, skinValueLook), low = lookOf(owner, skinLowLook), high = lookOf(owner, skinHighLook);
  skinFirst_ = int(shape.x);
  reliefSize_ = ivec2(shape.yz);
  reliefLevels_ = int(shape.w & 255u);
  skinLook_ = int(shape.w >> 8);
  skinThreshold_ = values.x;
  skinRoughness_ = values.y;
  skinDepth_ = values.z;
  skinCells_ = vec2(values.w, low.w);
  skinLow_ = low.rgb;
  skinHigh_ = high.rgb;
  return reliefLevels_ > 0;
}

struct HitSkin {
  Skin skin;
  vec3 normal;
};
HitSkin skinLaid(int owner, Laid laid, vec3 normal) {
  vec2 slopeX = vec2(0), slopeY = vec2(0), slopeZ = vec2(0);
  SkinArea area;
  precise float q = 0.0f;
  precise float variance = 0.0f;
  precise float around = 0.0f;
  precise vec3 color = vec3(0);
  precise vec2 change = vec2(0);
  int left = laidSides(laid.weight);
  while (left != 0) {
    int side = findLSB(left);
    left &= left - 1;
    Seen seen = laidSide(laid, side);
    SkinArea one = skinArea(seen);
    float weight = laidWeight(laid, side);
    q = q + one.q * weight;
    variance = variance + one.variance * weight;
    around = around + one.around * weight;
    color = color + one.color * weight;
    change = change + changeOver(one, seen) * weight;
    slopeX = side == 0 ? one.slope : slopeX;
    slopeY = side == 1 ? one.slope : slopeY;
    slopeZ = side == 2 ? one.slope : slopeZ;
  }
  area.q = q;
  area.variance = variance;
  area.around = around;
  area.color = color;
  area.slope = slopeX;
  precise float change2 = change.x * change.x + change.y * change.y;
  vec3 rise = laid.sides ? riseLaid(owner, laid, normal, slopeX, slopeY, slopeZ)
                         : riseByUv(slopeX, normal, laid.right, laid.above, laid.x.across, laid.x.up);
  precise vec3 raised = normal - skinDepth_ * rise;
  return HitSkin(skinOf(area, change2), unitOf(raised));
}

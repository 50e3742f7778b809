// Computes the transform of the sun's shadow map from the bounds of the casters, or of their part that matters for the
// picture (seen_bounds.glsl). Then resets the bounds for the next frame. The side of the map grows in steps of 1/8 octave
// and its corner moves by whole texels, so that shadow edges do not crawl while the casters move. Runs as one invocation.
#include "draw/instances/bounds.glsl"
#include "draw/surface/seen_bounds.glsl"
layout(local_size_x = 1) in;
layout(std430, binding = lightBinding) restrict writeonly buffer LightBlock {
  vec4 light[5];
};

// Rounds up to a multiple of 1/8 of the largest power of two that is not above `size`. The exponent bits of the float
// give the power of two.
float stepped(float size) {
  int power = floatBitsToInt(size) & 0x7f800000;
  float unit = intBitsToFloat(power - (3 << 23)), perUnit = intBitsToFloat((257 << 23) - power);
  precise float steps = size * perUnit;
  precise float whole = ceil(steps) * unit;
  return whole;
}

void main() {
  vec3 low = vec3(0), high = vec3(0);
  vec4 ground = vec4(0);
  if (boundLow[0] <= boundHigh[0]) {
    low = vec3(fromOrderedKey(boundLow[0]), fromOrderedKey(boundLow[1]), fromOrderedKey(boundLow[2]));
    high = vec3(fromOrderedKey(boundHigh[0]), fromOrderedKey(boundHigh[1]), fromOrderedKey(boundHigh[2]));
    ground = vec4(fromOrderedKey(boundLow[3]), fromOrderedKey(boundLow[4]), fromOrderedKey(boundHigh[3]), fromOrderedKey(boundHigh[4]));
  }
  // Casters extend at most 2^17 texels, so their corners fit into integers of 1/256 texel.
  precise vec2 whole = (high.xy - low.xy) * (frame.shadowTexels * 7.62939453125e-6);
  // Mirrors may show any part of a ground, so only a picture without one needs no more than what the camera sees.
  if (frame.groundReach == 0.0 && frame.eye.w == 1.0) {
    LightBox seen = seenPart(LightBox(low, high));
    low = seen.low;
    high = seen.high;
  }
  // The map has a margin of `margin` texels around the bounds, so filters of visible receivers read no texels beyond
  // the map.
  float texels = frame.shadowTexels;
  precise float softness = ceil(frame.shadowReach) + 2.0;
  precise float quarter = 0.25 * texels;
  float margin = min(softness, quarter);
  precise vec3 extent = high - low;
  float size = stepped(max(max(max(extent.x, extent.y), max(whole.x, whole.y)), 0.05));
  precise float inner = texels - 2.0 * margin - 1.0;
  precise float texel = size * exactReciprocal(inner);
  precise vec2 steps = low.xy * (inner * exactReciprocal(size));
  precise vec2 corner = (floor(steps) - margin) * texel;
  precise float side = texel * texels;
  precise float depth = stepped(max(extent.z, 0.05)) * 1.02;
  // Depth 0 is nearest to the light.
  precise float nearest = high.z + 0.01 * depth;
  float perSide = exactReciprocal(side), perDepth = exactReciprocal(depth);
  precise vec4 right = vec4(frame.lightRight.xyz, -corner.x) * perSide;
  precise vec4 up = vec4(frame.lightUp.xyz, -corner.y) * perSide;
  precise vec4 along = vec4(-frame.sunDirection.xyz, nearest) * perDepth;
  light[0] = right;
  light[1] = up;
  light[2] = along;
  light[3] = vec4(texel, side, depth, 0);
  precise float reach = margin * texel * exactReciprocal(sunHeight());
  precise vec4 reached = ground + vec4(-reach, -reach, reach, reach);
  light[4] = reached;
  for (int i = 0; i < boundCount; ++i) {
    boundLow[i] = 0xffffffffu;
    boundHigh[i] = 0u;
  }
}

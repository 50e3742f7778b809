// One invocation: turns the bounds into the light's map and empties them for the next frame.
// The side of the map goes up in steps of 1/8 octave and its corner moves by whole texels, so edges of
// shadows hold still while the caster moves.
#include "draw/instances/bounds.glsl"
layout(local_size_x = 1) in;
layout(std430, binding = lightBinding) restrict writeonly buffer LightBlock {
  vec4 light[5];
};

float stepped(float size) {
  float unit = exp2(floor(log2(size)) - 3.0);
  return ceil(size / unit) * unit;
}

void main() {
  vec3 low = vec3(0), high = vec3(0);
  vec4 ground = vec4(0);
  if (boundLow[0] <= boundHigh[0]) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = fromOrderedKey(boundLow[axis]);
      high[axis] = fromOrderedKey(boundHigh[axis]);
    }
    for (int axis = 0; axis < 2; ++axis) {
      ground[axis] = fromOrderedKey(boundLow[3 + axis]);
      ground[axis + 2] = fromOrderedKey(boundHigh[3 + axis]);
    }
  }
  // No caster lies within `margin` texels of the border, so reading past the border finds no shadow.
  float texels = frame.shadowTexels;
  float margin = min(ceil(frame.shadowSoftness) + 2.0, 0.25 * texels);
  float size = stepped(max(max(high.x - low.x, high.y - low.y), 0.05));
  float texel = size / (texels - 2.0 * margin - 1.0);
  vec2 corner = (floor(low.xy / texel) - margin) * texel;
  float side = texel * texels;
  float depth = stepped(max(high.z - low.z, 0.05)) * 1.02;
  // Depth 0 is nearest to the light.
  float nearest = high.z + 0.01 * depth;
  light[0] = vec4(frame.lightRight.xyz, -corner.x) / side;
  light[1] = vec4(frame.lightUp.xyz, -corner.y) / side;
  light[2] = vec4(-frame.sunDirection.xyz, nearest) / depth;
  light[3] = vec4(texel, side, depth, 0);
  float reach = margin * texel / sunHeight();
  light[4] = ground + vec4(-reach, -reach, reach, reach);
  for (int i = 0; i < boundCount; ++i) {
    boundLow[i] = 0xffffffffu;
    boundHigh[i] = 0u;
  }
}

#include "common/exact.glsl"
#include "spread/paint.glsl"
#include "spread/wildfire/types.glsl"
layout(std140, binding = stepBinding) uniform StepBlock { WildfireStep stepData; };
INPUT_WORDS(groundBinding, GroundBlock, ground)
float climbFactor(int i) { return 1.0f; }
#include "spread/wildfire/gale.glsl"
#include "spread/wildfire/model.glsl"

uint painted(uint cell, int value, ivec2 at) {
  uvec4 shades = LOAD_INPUT_WORDS(ground, at.y * ((size.x + 15) >> 4) + (at.x >> 4));
  int k = at.x & 15;
  return paintedFuel(cell, value, shades[k >> 2] >> uint(8 * (k & 3)) & 255u);
}
#include "spread/paint_main.glsl"

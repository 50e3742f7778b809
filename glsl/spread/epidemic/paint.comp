#include "spread/paint.glsl"
#include "spread/epidemic/types.glsl"
layout(std140, binding = stepBinding) uniform StepBlock { EpidemicStep stepData; };
#include "spread/epidemic/model.glsl"

uint painted(uint cell, int value, ivec2 at) {
  return paintedPerson(cell, value);
}
#include "spread/paint_main.glsl"

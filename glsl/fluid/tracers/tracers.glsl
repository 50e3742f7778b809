// Includes and buffers common to the tracer kernels.
#define WIND 1
#include "common/exact.glsl"
#include "common/hash.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "fluid/tracers/tracer_types.glsl"
#include "fluid/wind_array.glsl"
layout(local_size_x = 64) in;
STATE_ARRAY(tracersBinding, TracerBlock, tracers)
INPUT_WORDS(solidBinding, SolidBlock, solidBits)
uniform TracerStep tracerData;
uniform int count;

bool tracerInSolid(int x, int y) {
  int bit = y * windGrid.size.x + x;
  return (LOAD_INPUT_WORDS(solidBits, bit >> 7)[bit >> 5 & 3] >> uint(bit & 31) & 1u) == 1u;
}
#include "fluid/tracers/tracer_model.glsl"

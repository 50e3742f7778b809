// Computes one step of all floating bodies. A workgroup processes one body; each of its invocations processes a part of
// the body's points. Sums have a fixed order. The effects on the water are summed as integers, so their order does not
// matter.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/status.glsl"
#include "water/bindings.glsl"
#include "water/float_bindings.glsl"
#include "water/types.glsl"
#include "water/float_types.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(cellsBinding, CellBlock, cells)
INPUT_ARRAY(floatsBinding, FloatsBlock, bodies)
STATE_ARRAY(nextFloatsBinding, NextFloatsBlock, nextBodies)
INPUT_ARRAY(floatParametersBinding, FloatParametersBlock, floatInput)
INPUT_ARRAY(floatPointsBinding, FloatPointBlock, points)
layout(std430, binding = floatSumsBinding) restrict buffer FloatSumBlock { int sums[]; };
layout(std140, binding = stepBinding) uniform FloatBlock { FloatStep floats; };
uniform ivec2 size;
uniform int stepNumber;  // Zero-based step of the frame, or a negative number for the initial state, for which only the
                         // sums are computed
uniform int cellCount;
shared vec4 parts[192];

vec4 loadWater(int i) { return LOAD_INPUT(cells, i); }
vec4 loadFloat(int i) { return LOAD_INPUT(bodies, i); }
vec4 loadParameters(int i) { return LOAD_INPUT(floatInput, i); }
vec4 loadFloatPoint(int i) { return LOAD_INPUT(points, i); }
void addToSum(int cell, int which, int value) { atomicAdd(sums[cell * 4 + which], value); }
#include "water/model.glsl"
#include "water/float_model.glsl"
#include "water/float_contact.glsl"
#include "water/float_motion.glsl"

// Reduces the contacts of all lanes to the first lane, in a fixed order.
FloatMeet meetOfAll(int lane, FloatMeet meet) {
  barrier();
  parts[lane * 3] = meet.place;
  parts[lane * 3 + 1] = meet.way;
  for (int stride = floatLanes / 2; stride > 0; stride /= 2) {
    barrier();
    if (lane < stride) {
      FloatMeet other;
      other.place = parts[(lane + stride) * 3];
      other.way = parts[(lane + stride) * 3 + 1];
      meet = floatMet(meet, other);
      parts[lane * 3] = meet.place;
      parts[lane * 3 + 1] = meet.way;
    }
  }
  return meet;
}

void main() {
  int me = int(gl_WorkGroupID.x), lane = int(gl_LocalInvocationID.x);
  FloatBody body = floatBody(me);
  FloatParameters t = floatParameters(me);
  FloatSum sum = floatLane(lane, body, t);
  parts[lane * 3] = sum.push;
  parts[lane * 3 + 1] = sum.turn;
  parts[lane * 3 + 2] = sum.rest;
  for (int stride = floatLanes / 2; stride > 0; stride /= 2) {
    barrier();
    if (lane < stride) {
      FloatSum other;
      other.push = parts[(lane + stride) * 3];
      other.turn = parts[(lane + stride) * 3 + 1];
      other.rest = parts[(lane + stride) * 3 + 2];
      sum = floatAdded(sum, other);
      parts[lane * 3] = sum.push;
      parts[lane * 3 + 1] = sum.turn;
      parts[lane * 3 + 2] = sum.rest;
    }
  }
  for (int i = 0; i < floats.count; ++i) {
    if (i == me || stepNumber < 0) continue;
    FloatBody other = floatBody(i);
    FloatParameters o = floatParameters(i);
    bool isFirst = me < i;
    FloatBody first = isFirst ? body : other;
    FloatParameters a = isFirst ? t : o, b = isFirst ? o : t;
    FloatBody second = floatBeside(first, isFirst ? other : body);
    if (!floatNear(first, a, second, b)) continue;
    FloatMeet meet = meetOfAll(lane, floatMeetLane(lane, first, a, second, b));
    sum = floatWithPush(sum, meet, floatPushed(meet, first, a, second, b), isFirst, first, second);
  }
  if (lane != 0) return;
  FloatBody next = body;
  if (stepNumber >= 0) next = floatMoved(stepNumber, body, t, sum);
  next.under = sum.push.w;
  next.wet = sum.rest.y;
  STORE_STATE(nextBodies, me * floatTexels, vec4(next.at, next.level));
  STORE_STATE(nextBodies, me * floatTexels + 1, next.turn);
  STORE_STATE(nextBodies, me * floatTexels + 2, vec4(next.velocity, next.under));
  STORE_STATE(nextBodies, me * floatTexels + 3, vec4(next.spin, 0.0f));
  STORE_STATE(nextBodies, me * floatTexels + 4, vec4(next.stages, next.around, next.wet));
  if (!(isNumber(next.at.x) && isNumber(next.at.y) && isNumber(next.at.z) && isNumber(next.turn.w) && isNumber(next.spin.x)))
    noteLost(uint(max(stepNumber, 0) + 1), uint(cellCount + me));
}

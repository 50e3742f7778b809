FloatStep floats;
ivec2 size;
int pond;

FUNCTION vec4 loadWater(int i) {
  uvec3 bits = diced(i, pond);
  precise float bed = float(int(bits.x % 4u)) * 0.25f - 0.5f;
  float depth = (bits.y & 3u) == 0u ? 0.0f : 0.25f + 0.25f * abs(signedUnit(bits.y));
  precise float level = bed + depth;
  precise vec2 flow = vec2(signedUnit(bits.z), someNumber(bits.z)) * depth;
  return vec4(level, flow.x, flow.y, bed);
}
// Returns texel i of the state of two bodies: position, rotation, velocity and angular velocity.
FUNCTION vec4 loadFloat(int i) {
  vec3 place = somePlace(i, pond + 1);
  if (i % floatTexels == 1) return vec4(0.6f, 0.0f, place.x < 0.0f ? -0.8f : 0.0f, place.x < 0.0f ? 0.0f : 0.8f);
  return vec4(place, 0.25f);
}
FUNCTION vec4 loadParameters(int i) {
  int body = i / floatParameterTexels, what = i % floatParameterTexels;
  if (what == 0) return vec4(2.0f, 0.5f, 0.75f, 0.25f);
  if (what == 1) return vec4(3.0f, 2.0f, 4.0f, 0.0f);
  if (what == 2) return vec4(0.125f, -0.25f, 0.5f, 6.0f);
  if (what == 3) return vec4(0.25f, 0.125f, 0.5f, 0.75f);
  if (what == 4) return vec4(0.5f, 0.25f, 1.5f, 0.75f);
  if (what == 5) return vec4(float(someOf(pond + i, 6, 3)), 0.25f, 0.5f, 0.375f);
  if (what == 6) return vec4(0.5f, -0.25f, 0.125f, 0.25f);
  if (what == 7) return vec4(0.6f, 0.8f, 0.25f, body == 0 ? 0.5f : 0.0f);
  if (what == 8) return vec4(2.0f, 0.5f, 1.0f, 0.25f);
  if (what == 9) return vec4(0.0f, 5.0f, 40.0f, body == 0 && pond % 3 == 0 ? 0.25f : 0.0f);
  if (what == 10) return vec4(-0.5f, -0.5f, -0.5f, 2.0f);
  return vec4(3.0f, 4.0f, 3.0f, 0.5f);
}
FUNCTION vec4 loadFloatPoint(int i) {
  vec3 place = somePlace(i, 8);
  float last = i < 40 ? 0.0625f : 0.5f * someNumber(diced(i, 9).x);
  return vec4(0.5f * place, last);
}
ivec4 summed;
FUNCTION void addToSum(int cell, int which, int value) {
  summed[which] += value * (cell + 1);
}

#include "water/float_model.glsl"
#include "water/float_contact.glsl"
#include "water/float_motion.glsl"

FUNCTION vec4 asked(int i) {
  pond = 5 * i;
  summed = ivec4(0);
  size = ivec2(5, 3);
  floats.dt = 0.0625f;
  floats.gravity = 10.0f;
  floats.density = 1000.0f;
  floats.perCell = 2.0f;
  floats.columns = 2.5f;
  floats.rows = 1.5f;
  floats.halfX = 1.25f;
  floats.halfZ = 0.75f;
  floats.depthUnit = 0.0009765625f;
  floats.perDepthUnit = 4096.0f;
  floats.flowUnit = 0.00048828125f;
  floats.perFlowUnit = 0.5f;
  floats.stiff = 8.0f;
  floats.damp = 6.4f;
  floats.deepest = 0.125f;
  floats.thin = 0.03125f;
  floats.dry = 0.0078125f;
  floats.maximum = 0.75f;
  floats.west = i % 3 == 0 ? periodicEdge : wallEdge;
  floats.east = floats.west;
  floats.north = i % 5 == 0 ? periodicEdge : wallEdge;
  floats.south = floats.north;
  floats.count = 2;
  FloatBody first = floatBody(0);
  FloatBody second = floatBeside(first, floatBody(1));
  FloatParameters a = floatParameters(0), b = floatParameters(1);
  int what = i % 8;
  if (what == 0) return floatDistance(b, 2.0f * somePlace(i, 11));
  if (what < 3) {
    FloatMeet meet = floatMeetLane(0, first, a, second, b);
    vec3 force = floatPushed(meet, first, a, second, b);
    FloatSum sum;
    sum.push = vec4(0.0f);
    sum.turn = vec4(0.0f);
    sum.rest = vec4(0.0f);
    FloatSum both = floatWithPush(sum, meet, force, what == 1, first, second);
    return vec4(vec3(both.turn) + vec3(both.push), floatNear(first, a, second, b) ? 1.0f : 0.0f);
  }
  if (what < 5) {
    FloatSum sum = floatLane(someOf(i, 12, 2), first, a);
    return what == 3 ? vec4(vec3(sum.push), float(summed.x)) : vec4(vec3(sum.turn) + vec3(sum.rest.x), float(summed.y - summed.z));
  }
  if (what == 5) {
    FloatSum sum;
    sum.push = vec4(4.0f * somePlace(i, 13), 0.25f);
    sum.turn = vec4(somePlace(i, 14), i % 7 == 0 ? 0.0f : 0.25f);
    sum.rest = vec4(someNumber(diced(i, 15).x));
    FloatBody moved = floatMoved(someOf(i, 16, 4), first, a, sum);
    precise vec3 mixed_ = moved.at + 2.0f * vec3(moved.turn) + 4.0f * moved.velocity;
    precise vec3 spun = mixed_ + 8.0f * moved.spin;
    return vec4(spun, moved.level);
  }
  if (what == 6) {
    ivec2 within = ivec2(someOf(i, 17, 6), someOf(i, 18, 6));
    FloatWater w = floatWater(8.0f * someNumber(diced(i, 19).x), 4.0f * someNumber(diced(i, 19).y));
    precise float sum = w.share + w.level + 2.0f * w.slopeX + 4.0f * w.slopeZ + 8.0f * w.bedX + 16.0f * w.bedZ;
    precise float flows = w.u + 2.0f * w.v + 4.0f * w.depth + 8.0f * w.bed;
    return vec4(float(floatOwned(0, within)), float(floatOwned(1, within)), sum, flows);
  }
  uvec3 bits = diced(i, 20);
  ivec4 sums = ivec4(int(bits.x % 512u), int(bits.y % 4096u) - 2048, int(bits.z % 4096u) - 2048, int(bits.y >> 16u) % 512);
  vec4 texel = loadWater(i);
  vec4 pressed = floatPressed(texel, sums);
  precise float owed = pressed.w + float(floatDisplaced(texel, sums));
  return vec4(pressed.x, pressed.y, pressed.z, owed);
}

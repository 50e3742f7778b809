DeformStep deformStep;

// Returns depth and rim of the trail of footprints.
FUNCTION vec4 loadTrail(int i) {
  vec3 print_ = somePlace(i, 30);
  return vec4(abs(print_.x), abs(print_.y), 0.0f, 0.0f);
}

#include "mesh/model.glsl"

FUNCTION vec4 asked(int i) {
  deformStep.trail.cells = ivec2(5, 3);
  deformStep.trail.corner = vec2(-0.75f, -0.5f);
  deformStep.trail.cellSize = vec2(0.25f, 0.5f);
  deformStep.trail.perCell = vec2(4.0f, 2.0f);
  deformStep.trail.height = 0.125f;
  deformStep.trail.depth = 0.25f;
  deformStep.trail.rim = 0.5f;
  deformStep.trail.perRimWidth = 4.0f;
  deformStep.presserCount = 2;
  for (int k = 0; k < 2; ++k) {
    vec3 start = somePlace(i, 40 + k), end = someOf(i, 42 + k, 3) == 0 ? start : somePlace(i, 44 + k);
    precise vec3 axis = end - start;
    float square = exactDot(axis, axis);
    precise float flat_ = axis.x * axis.x + axis.z * axis.z;
    deformStep.pressers[k].start = vec4(start, 0.0f);
    deformStep.pressers[k].end = vec4(end, 0.0f);
    deformStep.pressers[k].radius = 0.375f;
    deformStep.pressers[k].perLength2 = square > 0.0f ? exactReciprocal(square) : 0.0f;
    deformStep.pressers[k].perFlat2 = flat_ > 0.0f ? exactReciprocal(flat_) : 0.0f;
  }
  vec3 rest = somePlace(i, 0);
  precise vec3 p = rest + 0.25f * somePlace(i, 1);
  int kind = i % 6;
  if (kind == 0) {
    RippleStep d;
    d.centre = vec4(0.25f, 0.0f, -0.5f, 0.0f);
    d.amplitude = 0.5f;
    d.decay = i % 4 == 0 ? 0.0f : 0.75f;
    d.wavenumber = 5.0f;
    d.phase = 1.5f;
    return vec4(rippled(d, rest, p), 0.0f);
  }
  if (kind == 1) {
    WaveStep d;
    d.heading = vec2(0.6f, -0.8f);
    d.amplitude = 0.25f;
    d.surge = 0.125f;
    d.wavenumber = 3.0f;
    d.phase = 0.5f;
    return vec4(waved(d, rest, p), 0.0f);
  }
  if (kind == 2) {
    SwayStep d;
    d.heading = vec2(0.8f, 0.6f);
    d.amplitude = 0.5f;
    d.base = -0.25f;
    d.perHeight = 0.75f;
    d.lean = 0.5f;
    d.gusts = 0.75f;
    d.wavenumber = 2.0f;
    d.phases = vec4(0.5f, 1.5f, 2.5f, 0.0f);
    return vec4(swayed(d, rest, p), 0.0f);
  }
  if (kind == 3) return vec4(pressed(1.25f * rest, p), 0.0f);
  if (kind == 4) {
    PushStep d;
    d.softness = 0.25f;
    d.base = -0.25f;
    d.perHeight = i % 4 == 0 ? 0.0f : 1.5f;
    return vec4(pushed(d, rest, p), 0.0f);
  }
  return trodden(ivec2(someOf(i, 2, 5), someOf(i, 3, 3)), vec4(abs(somePlace(i, 4)), 0.0f));
}

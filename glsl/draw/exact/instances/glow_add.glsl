// Adds the light of glows that lie in front of the visible samples to the sums of draw/instances/glow_block.glsl. Define:
// SAMPLES.
#include "draw/exact/view_block.glsl"
#include "draw/exact/triangles/triangle.glsl"
#define GLOW_FIRST_ROW view.rows.x
#include "draw/instances/glow_block.glsl"
#include "draw/exact/sample_read.glsl"

// Returns the number of the pixel's samples whose content is farther away than the nearness `near` (near plane /
// depth).
int samplesBefore(ivec2 pixel, float near) {
  uint key = nearKey(near);
  int at = firstSample(pixel), count = 0;
  for (int s = 0; s < SAMPLES; ++s) count += key < keyAt(at + s) ? 1 : 0;
  return count;
}

// Adds light to the integer sums. Three words hold the lower parts of r, g and b, and three words the upper parts.
void addUnits(ivec2 pixel, vec3 light) {
  vec3 all_ = min(light, vec3(6e4f));  // clamps the light, because larger values are displayed as white anyway
  precise vec3 uppers = all_ * 0.00390625f;
  vec3 upper = floor(uppers);
  precise vec3 lower = (all_ - upper * glowUpper) * glowUnits;
  precise vec3 rounded = lower + 0.5f;
  uvec3 units = uvec3(rounded);
  int word = glowWord(pixel);
  for (int i = 0; i < 3; ++i) {
    uint carry = uint(upper[i]);
    if (units[i] != 0u && atomicAdd(glowSums[word + i], units[i]) > 0xffffffffu - units[i]) ++carry;
    if (carry != 0u) atomicAdd(glowSums[word + 3 + i], carry);
  }
}

// Adds the light times `inside`, a fraction, and times the fraction of visible samples.
void addPart(ivec2 pixel, vec3 light, float inside, int samples) {
  if (samples == 0) return;
  precise float part = inside * float(samples) * perSamples();
  precise vec3 all_ = light * part;
  addUnits(pixel, all_);
}

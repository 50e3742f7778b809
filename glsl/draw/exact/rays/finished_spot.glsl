// Layers of a visible spot (FINISHED). Also packs two values of a continuation ray into one number: the fraction of the
// response that is due to the lobe, plus twice the roughness in steps of 1/255.
#include "draw/exact/rays/finished_look.glsl"

Facet finishedSpot(Facet f, int at, vec3 base, float metallic) {
  uvec4 words = texelFetch(spots, 4 * at + 3);
  int owner = int(words.x & 0x7fffffffu);
  f = finishedFacet(f, owner, unpackedUnit(words.y));
  f = glassFacet(f, owner, base, metallic, words.x >> 31 != 0u);
  return settled(f);
}

float noteOf(float share, float roughness) {
  precise float middle = roughness * 255.0f + 0.5f;
  float steps = floor(middle);
  precise float note = clamp(share, 0.0f, 1.0f) + 2.0f * steps;
  return note;
}
float stepsOfNote(float note) {
  precise float half_ = note * 0.5f;
  return floor(half_);
}
float roughnessOfNote(float note) {
  precise float roughness = stepsOfNote(note) * 0.003921569f;
  return roughness;
}
float shareOfNote(float note) {
  precise float share = note - 2.0f * stepsOfNote(note);
  return share;
}

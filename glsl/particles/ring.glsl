// Slots of emitters. Compiles as GLSL and as C++. The including file provides `stepData` (ParticleStep).

// Returns a slot's emitter (-1 for particles of groups) and the slot's index among the substep's new particles (-1 if
// not new).
FUNCTION ivec2 ringPlace(int slot) {
  for (int e = 0; e < stepData.emitterCount; ++e) {
    int slots = stepData.emitters[e].slots;
    int place = slot - stepData.emitters[e].firstSlot;
    if (place < 0 || place >= slots) continue;
    int k = place - stepData.emitters[e].firstPlace;
    k = k < 0 ? k + slots : k;
    return ivec2(e, k < stepData.emitters[e].newborns ? k : -1);
  }
  return ivec2(-1, -1);
}

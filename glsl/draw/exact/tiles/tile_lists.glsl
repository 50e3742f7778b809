// Which tiles show which of what is drawn: a list each. Numbers of samples say whose they are: surface k has those from
// firstIds[k] to before firstIds[k + 1]; the ground has one, and none the last.
#include "draw/exact/bindings.glsl"
const uint groundId = 0xfffffffeu, emptyId = 0xffffffffu;

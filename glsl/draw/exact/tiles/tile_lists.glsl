// Lists of the tiles that show each drawn surface. Primitive ids identify the surface. Surface k has the ids
// firstIds[k] to firstIds[k + 1] - 1; the ground has groundId, and an empty sample has emptyId.
#include "draw/exact/bindings.glsl"
const uint groundId = 0xfffffffeu, emptyId = 0xffffffffu;

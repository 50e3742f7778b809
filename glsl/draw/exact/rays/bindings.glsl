// Where the kernels of draw/exact/rays bind what is theirs. Compiles as GLSL and as C++ (src/draw/exact/rays).
#ifndef EXACT_RAY_BINDINGS
#define EXACT_RAY_BINDINGS
// Texel views.
const int solidUnit = 20, solidNodeUnit = 21, ballUnit = 22, ballNodeUnit = 23;    // sorted, and the nodes above them
const int rayUnit = 24, rayHitUnit = 25, rayLightUnit = 26;                        // of paths
const int spotUnit = 27, spotListUnit = 28;
const int solidPlaceUnit = 29, solidCornerUnit = 30, solidWordUnit = 31;           // of all surfaces: vertices, triangles
const int solidIdUnit = 32, ballLookUnit = 33, rayLookUnit = 34, spotLightUnit = 35;
const int rayLayUnit = 36, raySkinUnit = 37, rayListUnit = 38, rayEmitterUnit = 39;                         // what is laid over; paths that go on
const int recordUnit = 0;  // as INPUT_WORDS
// Storage blocks.
const int outPlaceBinding = 0, outWordBinding = 1, outCornerBinding = 2, outRecordBinding = 3, rayBoundsBinding = 4;
const int outNodeBinding = 5, outIdBinding = 6, outLayBinding = 8;
const int outRayBinding = 0, outHitBinding = 1, outRayLightBinding = 2, outSpotLightBinding = 3, outListBinding = 4;
const int outCountBinding = 5;
const int outSpotBinding = 13;  // beside those of what shades
#endif

// Binding points of the ray tracing kernels in draw/exact/rays. Compiles as GLSL and as C++ (src/draw/exact/rays).
#ifndef EXACT_RAY_BINDINGS
#define EXACT_RAY_BINDINGS
// Texture units of texel views: triangles and balls in the order of their hierarchies, and the nodes of the
// hierarchies.
const int solidUnit = 20, solidNodeUnit = 21, ballUnit = 22, ballNodeUnit = 23;
const int rayUnit = 24, rayHitUnit = 25, rayLightUnit = 26;  // texel views: rays of paths, their hits and their light
const int spotUnit = 27, spotListUnit = 28;
// Texel views: geometry of all surfaces (vertex positions, triangle corners, vertex words).
const int solidPlaceUnit = 29, solidCornerUnit = 30, solidWordUnit = 31;
const int solidIdUnit = 32, ballLookUnit = 33, rayLookUnit = 34, spotLightUnit = 35;
// Texel views: texture positions of vertices, texels of skins, listed paths or rays, emitters.
const int rayLayUnit = 36, raySkinUnit = 37, rayListUnit = 38, rayEmitterUnit = 39;
const int recordUnit = 0;  // texel view: sort records in the order of the hierarchy; bound as INPUT_WORDS
// Binding points of storage blocks.
const int outPlaceBinding = 0, outWordBinding = 1, outCornerBinding = 2, outRecordBinding = 3, rayBoundsBinding = 4;
const int outNodeBinding = 5, outIdBinding = 6, outLayBinding = 8;
const int outRayBinding = 0, outHitBinding = 1, outRayLightBinding = 2, outSpotLightBinding = 3, outListBinding = 4;
const int outCountBinding = 5;
const int outSpotBinding = 13;  // must differ from the bindings of the shading kernels, which write the spots
#endif

// Binding points of the exact rasterizer's kernels, in addition to draw/bindings.glsl. Compiles as GLSL and as C++
// (src/draw/exact/bindings.hpp).
#ifndef DRAW_EXACT_BINDINGS
#define DRAW_EXACT_BINDINGS
// Binding points of uniform blocks.
const int viewBinding = 3;
// Texture units of texel views, in addition to the units of surfaces (positionUnit to paletteUnit).
const int vertexUnit = 19, indexUnit = 20, idUnit = 21, nearUnit = 22, mapUnit = 23;
const int firstIdUnit = 24, tileListUnit = 25, largeUnit = 26, counterUnit = 27, nearFoursUnit = 28, idFoursUnit = 29;
const int lampMapUnit = 30, fanUnit = 31;
// Texture units of texel views: texels of material maps; fraction of light that blended layers let through.
const int mapTexelUnit = 41, throughUnit = 42;
// Texture units of texel views: visibility of the previous blended layer, and of the opaque surfaces.
const int layerNearUnit = 43, layerIdUnit = 44, behindUnit = 45;
// Texture units of texel views of joined surfaces. The units are free because the kernels of joined surfaces read no
// normals or uvs.
const int ownerUnit = 1, lookUnit = 2;
// Binding points of storage blocks.
const int outVertexBinding = 0, nearBinding = 1, idBinding = 2, largeBinding = 3, counterBinding = 4;
const int tileListBinding = 5, dispatchBinding = 6, drawArgumentBinding = 7;
const int fanBinding = 8, binBinding = 9, nodeBinding = 10, cornerBinding = 11;
const int outNormalBinding = 5;
const int throughBinding = 12;
const int halfPixelBinding = 0;  // storage block: output of the occlusion and reflection kernels
const int litBinding = 1;
const int pixelNearnessBinding = 2, unevenBinding = 3;
// Image units.
const int sumImage = 0, pictureImage = 1, lightImage = 2, scatteredImage = 3;
const int nearnessImage = 4, arcImage = 5, opennessImage = 6, litImage = 7;
const int unevenImage = 5;  // the unit is free because the kernels that read it read no arcs
#endif

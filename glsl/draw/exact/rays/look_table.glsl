// Layout of the material table that ray kernels read: lookTexels texels for each owner (index of a material). Owner 0
// has no layers beyond the values that its spots store. Compiles as GLSL and as C++
// (src/draw/exact/rays/ray_looks.cpp).
#ifndef EXACT_RAY_LOOK_TABLE
#define EXACT_RAY_LOOK_TABLE
const int lookTexels = 18;
const int plainLook = 0;     // texel: roughness, metallic, translucency, 1 if the material casts shadows
const int lightLook = 1;     // texel: rgb emission; w strength of the coat
// Texel: roughness of coat and of sheen, opacity, alpha mode (above 0: cutoff of holes; -1: blended; 0: opaque).
const int layerLook = 2;
const int sheenLook = 3;     // texel: rgb sheen colour; w transmission
const int glassLook = 4;     // texel: index of refraction; 1 if thin; bump height of white (m), 0 without bump
const int absorbLook = 5;    // texel: rgb absorption inside a solid (1/m)
// One texel for each map, with the four words that mapShape() and mapWithin() of draw/exact/surface/map_read.glsl take.
const int colorMapLook = 6, normalMapLook = 7, metalRoughMapLook = 8, emissionMapLook = 9;
// Texel: repeats along u and v, strength of normal maps; scale of lengths for triplanar projection, else 0.
const int laidLook = 10;
const int modelLook = 11;    // three texels: axes of the surface's own space
// Texel: first texel of the skin, size of its mip level 0; number of levels (0: no skin) plus 256 times the look.
const int skinLook = 14;
const int skinValueLook = 15;  // texel: threshold, roughness, depth and cells along u of the skin
const int skinLowLook = 16, skinHighLook = 17;  // texels: rgb colours of the skin; w of skinLowLook: cells along v
#endif

// Layout of the material table that ray kernels read: lookTexels texels for each owner (index of a material). Owner 0
// has no layers beyond the values that its spots store. Compiles as GLSL and as C++
// (src/draw/exact/rays/ray_looks.cpp).
#ifndef EXACT_RAY_LOOK_TABLE
#define EXACT_RAY_LOOK_TABLE
const int lookTexels = 18;
const int plainLook = 0;     // roughness, metallic, translucency, 1 if it casts shadows
const int lightLook = 1;     // rgb emission; w strength of the coat
// roughness of coat and of sheen, opacity, alpha mode: above 0 the cutoff of holes, -1 blended, 0 opaque
const int layerLook = 2;
const int sheenLook = 3;     // rgb sheen colour; w transmission
const int glassLook = 4;     // index of refraction; 1 if thin; bump height of white (m), 0 without bump
const int absorbLook = 5;    // rgb absorption inside a solid (1/m)
// four words per map, as in map_read.glsl
const int colorMapLook = 6, normalMapLook = 7, metalRoughMapLook = 8, emissionMapLook = 9;
// repeats along u and v, strength of normal maps; scale of lengths for triplanar projection, else 0
const int laidLook = 10;
const int modelLook = 11;    // three texels: axes of the surface's own space
const int skinLook = 14;     // first texel, size of mip level 0; number of levels (0: no skin) plus 256 times the look
const int skinValueLook = 15;  // threshold, roughness, depth, cells along u
const int skinLowLook = 16, skinHighLook = 17;  // rgb colours; w of skinLowLook: cells along v
#endif

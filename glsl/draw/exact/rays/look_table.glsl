// The table of what the things are made of that rays meet: so many texels each, by owner. Owner 0 has nothing but what its spots say.
// Compiles as GLSL and as C++ (src/draw/exact/rays/ray_looks.cpp).
#ifndef EXACT_RAY_LOOK_TABLE
#define EXACT_RAY_LOOK_TABLE
const int lookTexels = 18;
const int plainLook = 0;     // roughness, metallic, translucency, whether it casts shadows
const int lightLook = 1;     // emission; strength of its coat
const int layerLook = 2;     // roughness of coat and of sheen, opacity, and what decides: its limit of holes, -1: it blends, 0: nothing
const int sheenLook = 3;     // colour of its sheen; transmission
const int glassLook = 4;     // index of refraction; 1: thin; height of a texture's white (m), 0 of what is flat
const int absorbLook = 5;    // what a solid absorbs (1/m)
const int colorMapLook = 6, normalMapLook = 7, metalRoughMapLook = 8, emissionMapLook = 9;  // as map_read.glsl has them
const int laidLook = 10;     // repeats along u and v, strength of normals; scale of lengths where laid on from three sides, else 0
const int modelLook = 11;    // three: the axes of the surface's own space
const int skinLook = 14;     // first texel, size of the first level, levels (0: no skin) and 256 times the look
const int skinValueLook = 15;  // threshold, roughness, depth, cells along u
const int skinLowLook = 16, skinHighLook = 17;  // colours; cells along v in the first
#endif

// Layout of the material table that ray kernels read. An owner is the index of a material; each has lookTexels texels.
// Owner 0 has only the values that its spots store, and no layers. Compiles as GLSL and as C++
// (src/draw/exact/rays/ray_looks.cpp).
#ifndef EXACT_RAY_LOOK_TABLE
#define EXACT_RAY_LOOK_TABLE
const int lookTexels = 18;
const int fallbackMaterial = 0;     // texel: roughness, metallic, translucency, 1 if the material casts shadows
const int lightLook = 1;     // texel: rgb emission; w: strength of the coat
// Texel: roughness of coat and of sheen, opacity, alpha mode (above 0: cutoff of holes; -1: blended; 0: opaque).
const int layerLook = 2;
const int sheenLook = 3;     // texel: rgb sheen colour; w: transmission
const int glassLook = 4;     // texel: index of refraction; 1 if thin; bump height of white (m), or 0 without bump
const int absorbLook = 5;    // texel: rgb absorption inside a solid (1/m)
// One texel per map. It holds the four words that mapShape() and mapWithin() of draw/exact/surface/map_read.glsl take.
const int colorMapLook = 6, normalMapLook = 7, metalRoughMapLook = 8, emissionMapLook = 9;
// Texel: repeats along u and v; strength of normal maps; length scale of triplanar projection, or 0 for uv.
const int laidLook = 10;
const int modelLook = 11;    // three texels: axes of the surface's object space
// Texel: index of the skin's first texel; size of mip level 0; number of levels (0: no skin) plus 256 times the look.
const int skinLook = 14;
const int skinValueLook = 15;  // texel: threshold, roughness, depth and cells along u of the skin
const int skinLowLook = 16, skinHighLook = 17;  // texels: rgb colours of the skin; w of skinLowLook: number of cells
                                                // along v
#endif

// Binding points that the draw passes and their shaders share. Compiles as GLSL and as C++ (src/draw/draw_state.hpp).
#ifndef DRAW_BINDINGS
#define DRAW_BINDINGS

// Binding points of uniform blocks.
const int frameBinding = 0, deformBinding = 1, lampBinding = 2;

// Texture units of surfaces and instances.
const int positionUnit = 0, normalUnit = 1, uvUnit = 2, albedoUnit = 3, lightUnit = 4, shadowUnit = 5;
const int velocityUnit = 6, shapeUnit = 7, listUnit = 8, argumentUnit = 9, stopUnit = 10;
const int reliefUnit = 11, skinColorUnit = 12, surroundingsUnit = 13, trailUnit = 14;
const int lampUnit = 15, lampShadowUnit = 16, cellUnit = 17;
const int paletteUnit = 18;
const int environmentUnit = 40, lampCellUnit = 46, turnUnit = 47;
const int vertexColorUnit = 6;  // used only by surfaces, which have no velocities, so the unit is free
// Texture units of the kernels that list visible instances, and of small sprites.
const int maskUnit = 0, beforeUnit = 1, blockFirstUnit = 2, blockCountUnit = 3;
const int spriteUnit = 0;
// Texture units of fields, charts and text.
const int wordUnit = 0, colorUnit = 1, reducedUnit = 2;
const int countUnit = 0, columnUnit = 1;
const int boxUnit = 0;
// Texture units of passes over the whole picture.
const int sceneUnit = 0, depthUnit = 1, bloomUnit = 1;

// Binding points of storage blocks.
const int maskBinding = 0, beforeBinding = 1, blockCountBinding = 2, blockFirstBinding = 3;
const int argumentBinding = 4, listBinding = 5, boundsBinding = 6, lightBinding = 7;
const int boxBinding = 0, cellBinding = 1, cellArgumentBinding = 2;
const int spriteBinding = 0, glowBinding = 1, sampleBinding = 0;

// Image units.
const int targetImage = 0, fieldImage = 0, reliefImage = 1, skinColorImage = 1, surroundingsImage = 2;

#endif

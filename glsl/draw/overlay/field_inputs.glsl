// What a shader gets of a field: its cells as its simulation keeps them, and its colours. Variants: CELLS (0 bits, 1
// bytes, 2 floats, 3 colours), CATEGORIES, COLORED.
#include "draw/bindings.glsl"
layout(binding = wordUnit) uniform usamplerBuffer words;
layout(binding = colorUnit) uniform samplerBuffer stops;
uniform ivec2 cells;     // of the field
uniform int rowWords;    // from one row to the next
uniform int firstWord;   // of cell (0, 0)
uniform int cellWords;   // of floats and colours: from a cell to the next
uniform int stopCount;
uniform float rangeLow;     // value of the first colour
uniform float rangeFactor;  // on what is above it: 1 at the last colour
#ifdef EXACT_PICTURE  // kernels, which read them before their loops
#include "common/once.glsl"
ivec2 cells_ = once(cells);
int rowWords_ = once(rowWords);
int firstWord_ = once(firstWord);
int cellWords_ = once(cellWords);
int stopCount_ = once(stopCount);
float rangeLow_ = once(rangeLow);
float rangeFactor_ = once(rangeFactor);
#define cells cells_
#define rowWords rowWords_
#define firstWord firstWord_
#define cellWords cellWords_
#define stopCount stopCount_
#define rangeLow rangeLow_
#define rangeFactor rangeFactor_
#endif
const int cellKind = CELLS;
#ifdef CATEGORIES
const bool categories = true;
#else
const bool categories = false;
#endif
#ifdef COLORED
const bool colored = true;
#else
const bool colored = false;
#endif

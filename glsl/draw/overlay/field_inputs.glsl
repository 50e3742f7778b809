// Uniforms and buffers of a field: its cells in the simulation's memory layout, and the colours of its colour map.
// Defines: CELLS (format of a cell: 0 bits, 1 bytes, 2 floats, 3 colours), CATEGORIES, COLORED.
#include "draw/bindings.glsl"
layout(binding = wordUnit) uniform usamplerBuffer words;
layout(binding = colorUnit) uniform samplerBuffer stops;
uniform ivec2 cells;     // size of the field in cells
uniform int rowWords;    // number of words from one row of cells to the next
uniform int firstWord;   // index of the word of cell (0, 0)
uniform int cellWords;   // number of words from one cell to the next, for cells of floats or colours
uniform int stopCount;
uniform float rangeLow;     // cell value of the first colour
uniform float rangeFactor;  // 1 / (value of the last colour - value of the first colour)
#ifdef EXACT_PICTURE  // copies, so that kernels read the uniforms only once, before their loops
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

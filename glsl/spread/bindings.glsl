#ifndef SPREAD_BINDINGS
#define SPREAD_BINDINGS

const int cellsBinding = 0;
const int nextCellsBinding = 1;
const int fuelsBinding = 2;
const int groundBinding = 3;
const int inclinesBinding = 4;
const int climbsBinding = 5;
const int countsBinding = 6;
const int stampsBinding = 7;
const int tilesBinding = 8;
const int galesBinding = 9;
const int nextTilesBinding = 5;  // Storage buffer that is used only on the texel path

#endif

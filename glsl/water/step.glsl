// One step of one cell, from the thirteen cells around it. Compiles as GLSL and as C++. The including file provides
// `water` (WaterStep), `size` (ivec2, cells) and loadWater(int i), a texel of the state. Define SEA as 1 if a side is a
// sea, otherwise 0.

// Returns the cell (x, y), which may be beyond the grid's sides. `told` and `grid` are local copies of `water` and
// `size`, so that the uniforms are read only once.
FUNCTION WaterCell waterAt(int x, int y, WaterStep told, ivec2 grid) {
  int column = waterFolded(x, grid.x, told.west, told.east);
  int row = waterFolded(y, grid.y, told.north, told.south);
  vec4 texel = loadWater(row * grid.x + column);
  WaterCell c = waterCell(texel, told.thin);
#if SEA
  bool west = x < 0 && told.west == seaEdge, east = x >= grid.x && told.east == seaEdge;
  bool north = y < 0 && told.north == seaEdge, south = y >= grid.y && told.south == seaEdge;
  if (west || east || north || south) {
    c = waterSea(texel, west ? told.seaWest : east ? told.seaEast : north ? told.seaNorth : told.seaSouth, told);
    float speed = west || north ? c.u : -c.u;
    c.u = west || east ? speed : 0.0f;
    c.v = west || east ? 0.0f : speed;
    return c;
  }
#endif
  return waterMirrored(c, waterIsMirrored(x, grid.x, told.west, told.east),
                       waterIsMirrored(y, grid.y, told.north, told.south));
}

FUNCTION vec4 waterStepped(int x, int y) {
  WaterStep told = water;
  ivec2 grid = size;
  vec4 texel = loadWater(y * grid.x + x);
  WaterCell c = waterCell(texel, told.thin);
  WaterCell e = waterAt(x + 1, y, told, grid);
  WaterCell w = waterAt(x - 1, y, told, grid);
  WaterCell n = waterAt(x, y - 1, told, grid);
  WaterCell s = waterAt(x, y + 1, told, grid);
  WaterCell ne = waterAt(x + 1, y - 1, told, grid);
  WaterCell nw = waterAt(x - 1, y - 1, told, grid);
  WaterCell se = waterAt(x + 1, y + 1, told, grid);
  WaterCell sw = waterAt(x - 1, y + 1, told, grid);
  WaterCell cx = waterSlope(w, c, e, told.dry);
  WaterCell cy = waterSlope(n, c, s, told.dry);
  WaterCell ex = waterSlope(c, e, waterAt(x + 2, y, told, grid), told.dry);
  WaterCell ey = waterSlope(ne, e, se, told.dry);
  WaterCell wx = waterSlope(waterAt(x - 2, y, told, grid), w, c, told.dry);
  WaterCell wy = waterSlope(nw, w, sw, told.dry);
  WaterCell nx = waterSlope(nw, n, ne, told.dry);
  WaterCell ny = waterSlope(waterAt(x, y - 2, told, grid), n, c, told.dry);
  WaterCell sx = waterSlope(sw, s, se, told.dry);
  WaterCell sy = waterSlope(c, s, waterAt(x, y + 2, told, grid), told.dry);
  WaterCell c2 = waterHalf(c, cx, cy, told.halfRatio, told.gravity);
  WaterCell e2 = waterHalf(e, ex, ey, told.halfRatio, told.gravity);
  WaterCell w2 = waterHalf(w, wx, wy, told.halfRatio, told.gravity);
  WaterCell n2 = waterHalf(n, nx, ny, told.halfRatio, told.gravity);
  WaterCell s2 = waterHalf(s, sx, sy, told.halfRatio, told.gravity);
  precise float most = c.depth * told.share;
  precise float mostE = e.depth * told.share;
  precise float mostW = w.depth * told.share;
  precise float mostN = n.depth * told.share;
  precise float mostS = s.depth * told.share;
  WaterFlux east = waterFlux(waterSideX(c, c2, cx, 0.5f), waterSideX(e, e2, ex, -0.5f), told.gravity, most, mostE);
  WaterFlux west = waterFlux(waterSideX(w, w2, wx, 0.5f), waterSideX(c, c2, cx, -0.5f), told.gravity, mostW, most);
  WaterFlux south = waterFlux(waterSideY(c, c2, cy, 0.5f), waterSideY(s, s2, sy, -0.5f), told.gravity, most, mostS);
  WaterFlux north = waterFlux(waterSideY(n, n2, ny, 0.5f), waterSideY(c, c2, cy, -0.5f), told.gravity, mostN, most);
  return waterGathered(texel, c2, cx, cy, east, west, south, north, told);
}

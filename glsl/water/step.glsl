// One step of one cell, from the thirteen cells around it. Compiles as GLSL and as C++. The including file provides
// `water` (WaterStep), `size` (ivec2, cells) and loadWater(int i), a texel of the state. Define SEA as 1 if a side is a
// sea, otherwise 0.

// Returns the cell (x, y), which may be beyond the grid's sides. `uniforms` and `grid` are local copies of `water` and
// `size`, so that the uniforms are read only once.
FUNCTION WaterCell waterAt(int x, int y, WaterStep uniforms, ivec2 grid) {
  int column = waterFolded(x, grid.x, uniforms.west, uniforms.east);
  int row = waterFolded(y, grid.y, uniforms.north, uniforms.south);
  vec4 texel = loadWater(row * grid.x + column);
  WaterCell c = waterCell(texel, uniforms.thin);
#if SEA
  bool west = x < 0 && uniforms.west == seaEdge, east = x >= grid.x && uniforms.east == seaEdge;
  bool north = y < 0 && uniforms.north == seaEdge, south = y >= grid.y && uniforms.south == seaEdge;
  if (west || east || north || south) {
    c = waterSea(texel, west ? uniforms.seaWest : east ? uniforms.seaEast : north ? uniforms.seaNorth : uniforms.seaSouth, uniforms);
    float speed = west || north ? c.u : -c.u;
    c.u = west || east ? speed : 0.0f;
    c.v = west || east ? 0.0f : speed;
    return c;
  }
#endif
  return waterMirrored(c, waterIsMirrored(x, grid.x, uniforms.west, uniforms.east),
                       waterIsMirrored(y, grid.y, uniforms.north, uniforms.south));
}

FUNCTION vec4 waterStepped(int x, int y) {
  WaterStep uniforms = water;
  ivec2 grid = size;
  vec4 texel = loadWater(y * grid.x + x);
  WaterCell c = waterCell(texel, uniforms.thin);
  WaterCell e = waterAt(x + 1, y, uniforms, grid);
  WaterCell w = waterAt(x - 1, y, uniforms, grid);
  WaterCell n = waterAt(x, y - 1, uniforms, grid);
  WaterCell s = waterAt(x, y + 1, uniforms, grid);
  WaterCell ne = waterAt(x + 1, y - 1, uniforms, grid);
  WaterCell nw = waterAt(x - 1, y - 1, uniforms, grid);
  WaterCell se = waterAt(x + 1, y + 1, uniforms, grid);
  WaterCell sw = waterAt(x - 1, y + 1, uniforms, grid);
  WaterCell cx = waterSlope(w, c, e, uniforms.dry);
  WaterCell cy = waterSlope(n, c, s, uniforms.dry);
  WaterCell ex = waterSlope(c, e, waterAt(x + 2, y, uniforms, grid), uniforms.dry);
  WaterCell ey = waterSlope(ne, e, se, uniforms.dry);
  WaterCell wx = waterSlope(waterAt(x - 2, y, uniforms, grid), w, c, uniforms.dry);
  WaterCell wy = waterSlope(nw, w, sw, uniforms.dry);
  WaterCell nx = waterSlope(nw, n, ne, uniforms.dry);
  WaterCell ny = waterSlope(waterAt(x, y - 2, uniforms, grid), n, c, uniforms.dry);
  WaterCell sx = waterSlope(sw, s, se, uniforms.dry);
  WaterCell sy = waterSlope(c, s, waterAt(x, y + 2, uniforms, grid), uniforms.dry);
  WaterCell c2 = waterHalf(c, cx, cy, uniforms.halfRatio, uniforms.gravity);
  WaterCell e2 = waterHalf(e, ex, ey, uniforms.halfRatio, uniforms.gravity);
  WaterCell w2 = waterHalf(w, wx, wy, uniforms.halfRatio, uniforms.gravity);
  WaterCell n2 = waterHalf(n, nx, ny, uniforms.halfRatio, uniforms.gravity);
  WaterCell s2 = waterHalf(s, sx, sy, uniforms.halfRatio, uniforms.gravity);
  precise float maximum = c.depth * uniforms.share;
  precise float maxE = e.depth * uniforms.share;
  precise float maxW = w.depth * uniforms.share;
  precise float maxN = n.depth * uniforms.share;
  precise float maxS = s.depth * uniforms.share;
  WaterFlux east = waterFlux(waterSideX(c, c2, cx, 0.5f), waterSideX(e, e2, ex, -0.5f), uniforms.gravity, maximum, maxE);
  WaterFlux west = waterFlux(waterSideX(w, w2, wx, 0.5f), waterSideX(c, c2, cx, -0.5f), uniforms.gravity, maxW, maximum);
  WaterFlux south = waterFlux(waterSideY(c, c2, cy, 0.5f), waterSideY(s, s2, sy, -0.5f), uniforms.gravity, maximum, maxS);
  WaterFlux north = waterFlux(waterSideY(n, n2, ny, 0.5f), waterSideY(c, c2, cy, -0.5f), uniforms.gravity, maxN, maximum);
  return waterGathered(texel, c2, cx, cy, east, west, south, north, uniforms);
}

// A whole step of one cell from the thirteen around it. Compiles as GLSL and as C++. Whoever includes it provides
// `water` (WaterStep), `size` (ivec2, cells) and loadWater(int x, int y), a texel of the state.

FUNCTION WaterCell waterAt(int x, int y) {
  int column = waterFolded(x, size.x, water.west, water.east);
  int row = waterFolded(y, size.y, water.north, water.south);
  WaterCell c = waterCell(loadWater(column, row), water.thin);
  return waterMirrored(c, waterIsMirrored(x, size.x, water.west, water.east),
                       waterIsMirrored(y, size.y, water.north, water.south));
}

FUNCTION vec4 waterStepped(int x, int y) {
  vec4 texel = loadWater(x, y);
  WaterCell c = waterCell(texel, water.thin);
  WaterCell e = waterAt(x + 1, y);
  WaterCell w = waterAt(x - 1, y);
  WaterCell n = waterAt(x, y - 1);
  WaterCell s = waterAt(x, y + 1);
  WaterCell ne = waterAt(x + 1, y - 1);
  WaterCell nw = waterAt(x - 1, y - 1);
  WaterCell se = waterAt(x + 1, y + 1);
  WaterCell sw = waterAt(x - 1, y + 1);
  WaterCell cx = waterSlope(w, c, e, water.dry);
  WaterCell cy = waterSlope(n, c, s, water.dry);
  WaterCell ex = waterSlope(c, e, waterAt(x + 2, y), water.dry);
  WaterCell ey = waterSlope(ne, e, se, water.dry);
  WaterCell wx = waterSlope(waterAt(x - 2, y), w, c, water.dry);
  WaterCell wy = waterSlope(nw, w, sw, water.dry);
  WaterCell nx = waterSlope(nw, n, ne, water.dry);
  WaterCell ny = waterSlope(waterAt(x, y - 2), n, c, water.dry);
  WaterCell sx = waterSlope(sw, s, se, water.dry);
  WaterCell sy = waterSlope(c, s, waterAt(x, y + 2), water.dry);
  WaterCell c2 = waterHalf(c, cx, cy, water.halfRatio, water.gravity);
  WaterCell e2 = waterHalf(e, ex, ey, water.halfRatio, water.gravity);
  WaterCell w2 = waterHalf(w, wx, wy, water.halfRatio, water.gravity);
  WaterCell n2 = waterHalf(n, nx, ny, water.halfRatio, water.gravity);
  WaterCell s2 = waterHalf(s, sx, sy, water.halfRatio, water.gravity);
  precise float most = c.depth * water.share;
  precise float mostE = e.depth * water.share;
  precise float mostW = w.depth * water.share;
  precise float mostN = n.depth * water.share;
  precise float mostS = s.depth * water.share;
  WaterFlux east = waterFlux(waterSideX(c, c2, cx, 0.5f), waterSideX(e, e2, ex, -0.5f), water.gravity, most, mostE);
  WaterFlux west = waterFlux(waterSideX(w, w2, wx, 0.5f), waterSideX(c, c2, cx, -0.5f), water.gravity, mostW, most);
  WaterFlux south = waterFlux(waterSideY(c, c2, cy, 0.5f), waterSideY(s, s2, sy, -0.5f), water.gravity, most, mostS);
  WaterFlux north = waterFlux(waterSideY(n, n2, ny, 0.5f), waterSideY(c, c2, cy, -0.5f), water.gravity, mostN, most);
  // Within the cell the pressure changes by g h dw.
  precise float pressX = water.gravity * c2.depth * cx.level;
  precise float pressY = water.gravity * c2.depth * cy.level;
  precise float out_ = (east.mass - west.mass) + (south.mass - north.mass);
  precise float outX = ((east.before - west.behind) + pressX) + (south.across - north.across);
  precise float outY = ((south.before - north.behind) + pressY) + (east.across - west.across);
  precise float level = texel.x - water.ratio * out_;
  level = level + water.rain;
  precise float qx = texel.y - water.ratio * outX;
  precise float qy = texel.z - water.ratio * outY;
  return waterSettled(vec3(level, qx, qy), texel.w, water);
}

// Effect of brushes on a cell. Compiles as GLSL (paint.comp) and as C++, after transport.glsl. Needs brushPaints(i,
// cell), which returns true if brush i paints a cell; brushes[i], the parameters of brush i; and firstBrush and
// endBrush, the index range of the brushes to apply.

FUNCTION float towards(float value, float aim, float part) {
  precise float next = value + (aim - value) * part;
  return next;
}

FUNCTION float pushed(float value, float force) {
  precise float next = value + force;
  return next;
}

// Returns true if brush i paints the cell (x, y). Cells outside the grid are not painted.
FUNCTION bool paintsCell(int i, int x, int y) {
  ivec2 cell = ivec2(insideX(x), insideY(y));
  bool there = leftKind == periodicSide || (x >= 0 && x < size.x);
  there = there && (topKind == periodicSide || (y >= 0 && y < size.y));
  return there && brushPaints(i, cell);
}

// Returns the weight of brush i at a position: 1 inside, falling to 0 at the rim of a soft brush.
FUNCTION float brushPart(int i, vec2 place) {
  FluidBrush b = brushes[i];
  if (b.reach.w == 0.0f) return 1.0f;
  precise vec2 p = place - vec2(b.segment.x, b.segment.y);
  precise vec2 d = vec2(b.segment.z, b.segment.w) - vec2(b.segment.x, b.segment.y);
  precise float along = (p.x * d.x + p.y * d.y) * b.reach.y;
  along = clamp(along, 0.0f, 1.0f);
  precise vec2 q = p - along * d;
  precise float inside = (b.reach.x - (q.x * q.x + q.y * q.y)) * b.reach.w;
  float held = clamp(inside, 0.0f, 1.0f);
  precise float part = held * held * (3.0f - 2.0f * held);
  return held < 1e-3f ? 0.0f : part;
}

FUNCTION float scaled(float value, float part) {
  precise float product = value * part;
  return product;
}

// paintedU() paints the left face of a cell, paintedV() the top face, if at least one of the cells on both sides is
// painted. A closed face is not changed.
FUNCTION float paintedU(int x, int y) {
  float u = flowAt(x, y).x;
  if (faceAt(x, y).x == 0.0f) return u;
  for (int i = firstBrush; i < endBrush; ++i)
    if (paintsCell(i, x, y) || paintsCell(i, x - 1, y)) {
      FluidBrush brush = brushes[i];
      float part = brushPart(i, placeOf(0, x, y));
      if ((brush.stamp.w & 1) != 0) u = towards(u, brush.flow.x, scaled(brush.reach.z, part));
      u = pushed(u, scaled(brush.force.x, part));
    }
  return exactFlush(u);
}

FUNCTION float paintedV(int x, int y) {
  float v = flowAt(x, y).y;
  if (faceAt(x, y).y == 0.0f) return v;
  for (int i = firstBrush; i < endBrush; ++i)
    if (paintsCell(i, x, y) || paintsCell(i, x, y - 1)) {
      FluidBrush brush = brushes[i];
      float part = brushPart(i, placeOf(1, x, y));
      if ((brush.stamp.w & 1) != 0) v = towards(v, brush.flow.y, scaled(brush.reach.z, part));
      v = pushed(v, scaled(brush.force.y, part));
    }
  return exactFlush(v);
}

FUNCTION float paintedHeat(int x, int y) {
  float heat = flowAt(x, y).z;
  for (int i = firstBrush; i < endBrush; ++i)
    if ((brushes[i].stamp.w & 2) != 0 && paintsCell(i, x, y) && !isSolid(x, y))
      heat = towards(heat, brushes[i].flow.z, scaled(brushes[i].reach.z, brushPart(i, placeOf(2, x, y))));
  return exactFlush(heat);
}

FUNCTION vec4 paintedCell(int x, int y) {
  int ix = insideX(x), iy = insideY(y);
  float u = paintedU(faceX(x), iy);
  float v = paintedV(ix, faceY(y));
  return vec4(beyondTopBottom(u, y), beyondLeftRight(v, x), paintedHeat(ix, iy), flowAt(x, y).w);
}

FUNCTION vec4 paintedDye(int x, int y) {
  if (beyondOpen(x, y)) return vec4(0.0f);
  int ix = insideX(x), iy = insideY(y);
  vec4 dye = dyeAt(ix, iy);
  for (int i = firstBrush; i < endBrush; ++i)
    if ((brushes[i].stamp.w & 4) != 0 && paintsCell(i, ix, iy) && !isSolid(ix, iy)) {
      FluidBrush brush = brushes[i];
      float part = scaled(brush.reach.z, brushPart(i, placeOf(2, ix, iy)));
      dye = vec4(towards(dye.x, brush.dye.x, part), towards(dye.y, brush.dye.y, part), towards(dye.z, brush.dye.z, part),
                 0.0f);
    }
  return vec4(wholeDye(dye.x), wholeDye(dye.y), wholeDye(dye.z), 0.0f);
}

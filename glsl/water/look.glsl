// Quantities of a water cell for drawing and display. Compiles as GLSL and as C++, after water/model.glsl. The
// including file provides `look` (WaterLook), `size` and loadWaterAt(int x, int y).

FUNCTION float waterDepth(vec4 texel) {
  precise float depth = texel.x - texel.w;
  return max(depth, 0.0f);
}

// Returns depth, level, speed and foam of a cell.
FUNCTION vec4 waterValues(int x, int y) {
  vec4 here = loadWaterAt(x, y);
  WaterCell c = waterCell(here, look.thin);
  vec4 e = loadWaterAt(min(x + 1, size.x - 1), y);
  vec4 w = loadWaterAt(max(x - 1, 0), y);
  vec4 n = loadWaterAt(x, max(y - 1, 0));
  vec4 s = loadWaterAt(x, min(y + 1, size.y - 1));
  precise float acrossX = e.x - w.x;
  precise float acrossY = s.x - n.x;
  float minimum = min(min(waterDepth(e), waterDepth(w)), min(waterDepth(n), waterDepth(s)));
  precise float steep = acrossX * acrossX + acrossY * acrossY;
  precise float slope = 0.5f * exactSqrt(steep) * exactReciprocal(look.cell);
  precise float foam = (slope - look.calm) * look.foam;
  precise float squared = c.u * c.u + c.v * c.v;
  foam = clamp(foam, 0.0f, 1.0f);
  return vec4(c.depth, here.x, exactSqrt(squared), minimum > look.shallow && c.depth > look.shallow ? foam : 0.0f);
}

// Returns the height above the bed at which the surface is drawn for a depth of water. Thin water is drawn below the
// bed, with a smooth transition, so that thin films are hidden. The shoreline, where the two surfaces intersect, then
// crosses cells smoothly.
FUNCTION float drawnAbove(float depth) {
  precise float ratio = max(depth, 0.0f) * exactReciprocal(look.shallow);
  precise float lacking = 1.0f - min(ratio, 1.0f);
  precise float above = depth - look.shallow * (lacking * lacking);
  return above;
}

// Returns the depth that is used for drawing thin water and dry ground: the level of adjacent deeper water minus the
// bed, at most 0 for a dry cell. A dry cell without adjacent water gets a constant depth below the bed.
FUNCTION float seenDepth(int x, int y, vec4 here, float depth) {
  precise float sum = 0.0f;
  precise float weights = 0.0f;
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) {
      vec4 near = loadWaterAt(clamp(x + i, 0, size.x - 1), clamp(y + j, 0, size.y - 1));
      precise float more = waterDepth(near) - look.shallow;
      float weight = more > 1e-6f ? more : 0.0f;
      sum = sum + weight * (near.x - here.w);
      weights = weights + weight;
    }
  precise float beside = sum * exactReciprocal(max(weights, 1e-6f));
  precise float under = -0.25f * look.cell;
  float lake = weights > 0.0f ? min(beside, 0.0f) : under;
  precise float ratio = depth * exactReciprocal(look.shallow);
  float thick = min(ratio, 1.0f);
  precise float seen = lake + (depth - lake) * thick;
  return depth > look.shallow ? depth : seen;
}

// Returns the apparent depth of the ground. Wave crests focus light on the ground, which makes it look nearer; troughs
// do the opposite.
FUNCTION float lookedThrough(int x, int y, vec4 here, float depth) {
  vec4 e = loadWaterAt(min(x + 1, size.x - 1), y);
  vec4 w = loadWaterAt(max(x - 1, 0), y);
  vec4 n = loadWaterAt(x, max(y - 1, 0));
  vec4 s = loadWaterAt(x, min(y + 1, size.y - 1));
  float minimum = min(min(waterDepth(e), waterDepth(w)), min(waterDepth(n), waterDepth(s)));
  precise float mean = 0.25f * ((e.x + w.x) + (n.x + s.x));
  precise float crest = 2.5f * (here.x - mean) * exactReciprocal(look.cell);
  float held = minimum > look.shallow ? clamp(crest, -0.6f, 0.6f) : 0.0f;
  precise float seen = depth * (1.0f - held);
  return seen;
}

// Returns depth, vertex height, speed and palette index of a cell: all its displayed values except the level.
FUNCTION vec4 waterShown(int x, int y) {
  vec4 values = waterValues(x, y);
  vec4 here = loadWaterAt(x, y);
  float above = drawnAbove(seenDepth(x, y, here, values.x));
  precise float level = here.w + above;
  precise float height = look.base + level;
  float through = lookedThrough(x, y, here, values.x);
  precise float depths = through * look.perClarity * 16.0f + 0.5f;
  precise float foams = values.w * float(foamColors - 1) + 0.5f;
  int depthColor = min(int(min(depths, 1000.0f)), depthColors - 1);
  return vec4(values.x, height, values.z, float(int(foams) * depthColors + depthColor));
}

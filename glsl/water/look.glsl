// Quantities of a water cell for drawing and display. Compiles as GLSL and as C++, after water/model.glsl. The
// including file provides `look` (WaterLook), `size` and loadWaterAt(int x, int y).

FUNCTION float waterDepth(vec4 texel) {
  precise float depth = texel.x - texel.w;
  return max(depth, 0.0f);
}

// Returns the slope of the level at a cell, and the least depth of the cell and its four neighbours.
FUNCTION vec2 waterSlopeAt(int x, int y) {
  vec4 here = loadWaterAt(x, y);
  vec4 e = loadWaterAt(min(x + 1, size.x - 1), y);
  vec4 w = loadWaterAt(max(x - 1, 0), y);
  vec4 n = loadWaterAt(x, max(y - 1, 0));
  vec4 s = loadWaterAt(x, min(y + 1, size.y - 1));
  precise float acrossX = e.x - w.x;
  precise float acrossY = s.x - n.x;
  precise float steep = acrossX * acrossX + acrossY * acrossY;
  precise float slope = 0.5f * exactSqrt(steep) * exactReciprocal(look.cell);
  float minimum = min(min(waterDepth(e), waterDepth(w)), min(waterDepth(n), waterDepth(s)));
  return vec2(slope, min(minimum, waterDepth(here)));
}

// Returns the foam of a cell, from 0 to 1: the mean over 3 x 3 cells with binomial weights, so that it has no corners at
// single cells. It fades where the water becomes thin.
FUNCTION float waterFoam(int x, int y) {
  precise float sum = 0.0f;
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) {
      vec2 at = waterSlopeAt(clamp(x + i, 0, size.x - 1), clamp(y + j, 0, size.y - 1));
      precise float foam = (at.x - look.calm) * look.foam;
      precise float thick = 4.0f * look.shallow;
      precise float deep = (at.y - look.shallow) * exactReciprocal(thick);
      precise float weight = (i == 0 ? 0.5f : 0.25f) * (j == 0 ? 0.5f : 0.25f);
      precise float share = clamp(foam, 0.0f, 1.0f) * clamp(deep, 0.0f, 1.0f) * weight;
      sum = sum + share;
    }
  return sum;
}

// Returns depth, level, speed and foam of a cell.
FUNCTION vec4 waterValues(int x, int y) {
  vec4 here = loadWaterAt(x, y);
  WaterCell c = waterCell(here, look.thin);
  precise float squared = c.u * c.u + c.v * c.v;
  float foam = look.foam > 0.0f ? waterFoam(x, y) : 0.0f;
  return vec4(c.depth, here.x, exactSqrt(squared), foam);
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

// Returns the depth that is used for drawing dry ground and films of water: a transition from the level of adjacent deeper
// water minus the bed to the cell's own depth. A film is water thinner than `shallow`; on steep rock, where the bed falls
// by more than twice that to the lowest of the eight cells around, it is water thinner than this fall, as waves leave it.
// Without adjacent water the transition begins a constant depth below the bed.
FUNCTION float seenDepth(int x, int y, vec4 here, float depth) {
  precise float sum = 0.0f;
  precise float weights = 0.0f;
  float lowest = here.w;
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) {
      vec4 near = loadWaterAt(clamp(x + i, 0, size.x - 1), clamp(y + j, 0, size.y - 1));
      precise float more = waterDepth(near) - look.shallow;
      precise float weight = more * more;
      weight = more > 1e-6f && (i != 0 || j != 0) ? weight : 0.0f;
      sum = sum + weight * (near.x - here.w);
      weights = weights + weight;
      lowest = min(lowest, near.w);
    }
  precise float fall = here.w - lowest;
  precise float gentle = 2.0f * look.shallow;
  bool steep = fall > gentle;
  float film = steep ? fall : look.shallow;
  precise float beside = sum * exactReciprocal(max(weights, 1e-12f));
  precise float under = -0.25f * look.cell;
  float most = steep ? depth : 0.0f;
  float lake = weights > 0.0f ? min(beside, most) : under;
  precise float ratio = depth * exactReciprocal(film);
  float thick = min(ratio, 1.0f);
  precise float seen = lake + (depth - lake) * thick;
  return depth > film ? depth : seen;
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

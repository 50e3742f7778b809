// What is drawn and shown of a cell. Compiles as GLSL and as C++; after water/model.glsl. Whoever includes it provides
// `look` (WaterLook), `size` and loadWaterAt(int x, int y).

FUNCTION float waterDepth(vec4 texel) {
  precise float depth = texel.x - texel.w;
  return max(depth, 0.0f);
}

// Depth, level, speed and foam.
FUNCTION vec4 waterValues(int x, int y) {
  vec4 here = loadWaterAt(x, y);
  WaterCell c = waterCell(here, look.thin);
  vec4 e = loadWaterAt(min(x + 1, size.x - 1), y);
  vec4 w = loadWaterAt(max(x - 1, 0), y);
  vec4 n = loadWaterAt(x, max(y - 1, 0));
  vec4 s = loadWaterAt(x, min(y + 1, size.y - 1));
  precise float acrossX = e.x - w.x;
  precise float acrossY = s.x - n.x;
  float least = min(min(waterDepth(e), waterDepth(w)), min(waterDepth(n), waterDepth(s)));
  precise float steep = acrossX * acrossX + acrossY * acrossY;
  precise float slope = 0.5f * exactSqrt(steep) * exactReciprocal(look.cell);
  precise float foam = (slope - look.calm) * look.foam;
  precise float squared = c.u * c.u + c.v * c.v;
  foam = clamp(foam, 0.0f, 1.0f);
  return vec4(c.depth, here.x, exactSqrt(squared), least > look.shallow && c.depth > look.shallow ? foam : 0.0f);
}

// The vertex of a cell, and its colour's number. Where there is no water it lies beneath the bed: as high as the water
// beside it, so that the two meet where they should.
FUNCTION vec4 waterVertex(int x, int y, vec4 values) {
  vec4 here = loadWaterAt(x, y);
  precise float sum = 0.0f;
  precise float count = 0.0f;
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) {
      vec4 near = loadWaterAt(clamp(x + i, 0, size.x - 1), clamp(y + j, 0, size.y - 1));
      bool wet = waterDepth(near) > look.shallow;
      sum = wet ? sum + near.x : sum;
      count = wet ? count + 1.0f : count;
    }
  precise float mean = sum * exactReciprocal(max(count, 1.0f));
  precise float under = here.w - 0.25f * look.cell;
  precise float lowest = here.w - look.shallow;
  float beside = min(mean, lowest);
  float hidden = count > 0.0f ? beside : under;
  float level = values.x > look.shallow ? here.x : hidden;
  precise float px = look.left + float(x) * look.cell;
  precise float py = look.base + level;
  precise float pz = look.back + float(y) * look.cell;
  precise float depths = values.x * look.perClarity * 16.0f + 0.5f;
  precise float foams = values.w * 15.0f + 0.5f;
  int depthColor = min(int(min(depths, 1000.0f)), depthColors - 1);
  return vec4(px, py, pz, float(int(foams) * depthColors + depthColor));
}

#include "contour/wall_types.glsl"

WallGrid wallGrid;
int land;

// Returns the contour class of a sample. Two thirds of the samples have class 0 or 1, and the outer ring has class 0.
FUNCTION int loadWallClass(int x, int y) {
  if (x < 1 || y < 1 || x > wallGrid.samples.x - 2 || y > wallGrid.samples.y - 2) return 0;
  int drawn = someOf(16 * y + x, land, 6);
  return drawn > 3 ? 1 : min(drawn, wallGrid.levelCount);
}
// Returns a value within the sample's class.
FUNCTION float loadWallValue(int x, int y) {
  int class_ = loadWallClass(x + 1, y + 1);
  float above = float(class_) * 0.25f;
  precise float value = above + 0.125f * (1.0f + someNumber(diced(16 * y + x, land + 1).y));
  return class_ < 0 ? 0.0f : value;
}

#include "contour/model.glsl"
#include "contour/wall_model.glsl"

FUNCTION vec4 asked(int i) {
  land = 2 * (i / 4);
  wallGrid.corner = vec2(-0.75f, -0.75f);
  wallGrid.spacing = 0.5f;
  wallGrid.perSpacing = 2.0f;
  wallGrid.bottom = -0.5f;
  wallGrid.roof = 1.25f;
  wallGrid.reach = 0.0625f;
  wallGrid.kept = 0.5f;
  wallGrid.bounce = 0.25f;
  wallGrid.ceiling = i % 8 < 3 ? 1 : 0;
  wallGrid.levelCount = wallGrid.ceiling == 1 ? 1 : 3;
  wallGrid.squares = 1;
  wallGrid.samples = ivec2(6, 5);
  for (int k = 0; k < 4; ++k) {
    wallGrid.heights[k] = 0.375f * float(k);
    wallGrid.levels[k] = 0.25f * float(k + 1);
  }
  if (i % 4 == 0) {
    Corners q;
    q.a = someOf(i, 3, 5);
    q.b = someOf(i, 4, 5);
    q.c = someOf(i, 5, 5);
    q.d = someOf(i, 6, 5);
    float saddles = float(saddlesOf(q) + 100 * edgeCrossingsOf(q));
    return vec4(float(trianglesOf(q)), float(lowTrianglesOf(q)), saddles + (isSaddle(q, someOf(i, 7, 5)) ? 0.5f : 0.0f),
                crossingPlace(someNumber(diced(i, 8).x), someNumber(diced(i, 8).y), someNumber(diced(i, 8).z)));
  }
  vec3 from = 1.5f * somePlace(i, 9);
  precise vec3 to = from + (i % 3 == 0 ? 1.0f : 0.25f) * somePlace(i, 10);
  WallMotion m = outOfWalls(from, to, somePlace(i, 11));
  return i % 2 == 0 ? vec4(m.position, m.velocity.x) : vec4(m.velocity, isRock(to) ? 1.0f : 0.0f);
}

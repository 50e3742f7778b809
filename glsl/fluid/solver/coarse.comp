// The coarsest levels, of at most 64x64 cells, by a single work group: down, the very coarsest by sweeps that go farther than they
// should each time (SOR), and up again, as descend.comp, bottom.comp and ascend.comp. Corrections stay in shared memory, each in
// its place; so on no level may a torus be an odd number of cells around, where cells of a colour would meet.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "fluid/bindings.glsl"
#include "fluid/model.glsl"
const int lanes = 256;
layout(local_size_x = lanes) in;
layout(std430, binding = poolBinding) readonly restrict buffer PoolBlock { float pool[]; };
layout(std430, binding = raisedOutBinding) writeonly restrict buffer RaisedOutBlock { vec4 raisedOut[]; };
INPUT_WORDS(weightsBinding, WeightBlock, weights)
uniform ivec4 levels[4];  // the finest first: cells; elements: where its openings start; its first cell in `values`
uniform int levelCount;
uniform int rhsStart, upStart;  // of the finest: elements of `pool` and `raisedOut`

shared float values[5440];  // 64x64 cells, and a quarter of them on each coarser level
shared float missing[1344];  // of all but the finest
shared float others[bottomCells];

ivec2 within(ivec2 c, ivec2 cells) {
#if LEFT == 4
  c.x = c.x < 0 ? c.x + cells.x : c.x >= cells.x ? c.x - cells.x : c.x;
#endif
#if TOP == 4
  c.y = c.y < 0 ? c.y + cells.y : c.y >= cells.y ? c.y - cells.y : c.y;
#endif
  return c;
}

bool isInside(ivec2 c, ivec2 cells) {
  return c.x >= 0 && c.y >= 0 && c.x < cells.x && c.y < cells.y;
}

vec2 facesOf(ivec4 grid, ivec2 c) {
  uvec4 four = LOAD_INPUT_WORDS(weights, grid.z + (c.y >> 1) * (grid.x / 2 + 1) + (c.x >> 1));
  return faceWeights((c.y & 1) == 0 ? ((c.x & 1) == 0 ? four.x : four.y) : ((c.x & 1) == 0 ? four.z : four.w));
}

vec4 weightsOf(ivec4 grid, ivec2 c) {
  vec2 own = facesOf(grid, c);
  return vec4(own.x, facesOf(grid, c + ivec2(1, 0)).x, own.y, facesOf(grid, c + ivec2(0, 1)).y);
}

float missingAt(int number, ivec4 grid, ivec2 c) {
  if (number > 0) return missing[grid.w - levels[0].x * levels[0].y + c.y * grid.x + c.x];
  return pool[4 * (rhsStart + (c.y >> 1) * (grid.x / 2 + 1) + (c.x >> 1)) + 2 * (c.y & 1) + (c.x & 1)];
}

float valueAt(ivec4 grid, ivec2 place) {
  ivec2 c = within(place, grid.xy);
  return isInside(c, grid.xy) ? values[grid.w + c.y * grid.x + c.x] : 0.0;
}

// Cell i of a colour, row by row; beyond the grid where there is none.
ivec2 cellOf(int i, int color, ivec4 grid) {
  int along = (grid.x + 1) / 2;
  int y = i / along;
  return ivec2(2 * (i - y * along) + ((y + color) & 1), y);
}

void sweep(int number, ivec4 grid, int color, bool fromNothing) {
  int count = (grid.x + 1) / 2 * grid.y;
  for (int i = int(gl_LocalInvocationIndex); i < count; i += lanes) {
    ivec2 c = cellOf(i, color, grid);
    if (c.x >= grid.x) continue;
    vec4 w = weightsOf(grid, c);
    float sum = 0.0;
    if (!fromNothing)
      sum = neighbours(w, valueAt(grid, c - ivec2(1, 0)), valueAt(grid, c + ivec2(1, 0)), valueAt(grid, c - ivec2(0, 1)),
                       valueAt(grid, c + ivec2(0, 1)));
    values[grid.w + c.y * grid.x + c.x] = relaxed(missingAt(number, grid, c), sum, diagonal(w));
  }
  barrier();
}

float leftOver(int number, ivec4 grid, ivec2 c) {
  if (!isInside(c, grid.xy)) return 0.0;
  return residual(missingAt(number, grid, c), weightsOf(grid, c), valueAt(grid, c), valueAt(grid, c - ivec2(1, 0)),
                  valueAt(grid, c + ivec2(1, 0)), valueAt(grid, c - ivec2(0, 1)), valueAt(grid, c + ivec2(0, 1)));
}

void restrict_(int number, ivec4 grid, ivec4 coarse) {
  int start = coarse.w - levels[0].x * levels[0].y;
  for (int i = int(gl_LocalInvocationIndex); i < coarse.x * coarse.y; i += lanes) {
    int y = i / coarse.x;
    ivec2 c = 2 * ivec2(i - y * coarse.x, y);
    missing[start + i] = restricted(leftOver(number, grid, c), leftOver(number, grid, c + ivec2(1, 1)));
  }
  barrier();
}

// As ascend.comp has it.
float coarseAt(ivec4 coarse, ivec2 place) {
  ivec2 c = within(place, coarse.xy);
  bool wall = (c.x < 0 && LEFT != openSide) || (c.x >= coarse.x && RIGHT != openSide) || (c.y < 0 && TOP != openSide) ||
              (c.y >= coarse.y && BOTTOM != openSide);
  if (wall) return noCell;
  ivec2 near = clamp(c, ivec2(0), coarse.xy - 1);
  float value = values[coarse.w + near.y * coarse.x + near.x];
  return value < noCell && near != c ? -value : value;
}

void raise(ivec4 grid, ivec4 coarse) {
  for (int i = int(gl_LocalInvocationIndex); i < grid.x * grid.y; i += lanes) {
    int y = i / grid.x;
    ivec2 c = ivec2(i - y * grid.x, y), here = c >> 1, to = here + 2 * (c & 1) - 1;
    float more = prolonged(coarseAt(coarse, here), coarseAt(coarse, ivec2(to.x, here.y)), coarseAt(coarse, ivec2(here.x, to.y)),
                           coarseAt(coarse, to));
    values[grid.w + i] = raised(values[grid.w + i], more);
  }
  barrier();
}

float otherAt(ivec4 grid, ivec2 place, bool odd) {
  ivec2 c = within(place, grid.xy);
  if (!isInside(c, grid.xy)) return 0.0;
  int i = c.y * grid.x + c.x;
  return odd ? others[i] : values[grid.w + i];
}

void solveCoarsest(int number, ivec4 grid) {
  int i = int(gl_LocalInvocationIndex);
  bool used = i < grid.x * grid.y;
  ivec2 c = ivec2(i % grid.x, i / grid.x);
  float rhs = used ? missingAt(number, grid, c) : 0.0;
  vec4 w = used ? weightsOf(grid, c) : vec4(0.0);
  float diag = diagonal(w), here = 0.0;
  if (used) values[grid.w + i] = 0.0;
  barrier();
  // To and fro between two arrays.
  for (int half_ = 0; half_ < 2 * bottomSweeps; ++half_) {
    bool odd = (half_ & 1) == 1;
    if (used) {
      float sum = neighbours(w, otherAt(grid, c - ivec2(1, 0), odd), otherAt(grid, c + ivec2(1, 0), odd),
                             otherAt(grid, c - ivec2(0, 1), odd), otherAt(grid, c + ivec2(0, 1), odd));
      here = ((c.x + c.y + half_) & 1) == 0 ? overrelaxed(here, relaxed(rhs, sum, diag)) : here;
      if (odd)
        values[grid.w + i] = here;
      else
        others[i] = here;
    }
    barrier();
  }
}

void main() {
  int last = levelCount - 1;
  for (int n = 0; n < last; ++n) {
    ivec4 grid = levels[n];
    sweep(n, grid, 0, true);
    sweep(n, grid, 1, false);
    restrict_(n, grid, levels[n + 1]);
  }
  solveCoarsest(last, levels[last]);
  for (int n = last - 1; n >= 0; --n) {
    ivec4 grid = levels[n];
    raise(grid, levels[n + 1]);
    sweep(n, grid, 0, false);
    sweep(n, grid, 1, false);
  }
  ivec4 grid = levels[0];
  ivec2 blocks = (grid.xy + 1) / 2;
  for (int i = int(gl_LocalInvocationIndex); i < blocks.x * blocks.y; i += lanes) {
    int y = i / blocks.x;
    ivec2 block = ivec2(i - y * blocks.x, y), c = 2 * block;
    raisedOut[upStart + block.y * (grid.x / 2 + 1) + block.x] =
        vec4(valueAt(grid, c), c.x + 1 < grid.x ? valueAt(grid, c + ivec2(1, 0)) : 0.0,
             c.y + 1 < grid.y ? valueAt(grid, c + ivec2(0, 1)) : 0.0,
             c.x + 1 < grid.x && c.y + 1 < grid.y ? valueAt(grid, c + ivec2(1, 1)) : 0.0);
  }
}

// Computes one step of a continuous automaton. Sums the neighbourhood of each cell with the weights of each kernel, row
// by row from the upper left in a fixed order, then applies the growth. An invocation processes four adjacent cells. A
// loaded cell contributes to all four with different weights, so the weights are stored as (w[c], w[c-1], w[c-2],
// w[c-3]). Defines: RANGE, KERNELS; REACHES, the half-width of the widest kernel in each row; SMOOTH_LIFE, with which
// kernel 0 is the ring and kernel 1 the disc.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "lenia/bindings.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
INPUT_ARRAY(paddedBinding, PaddedBlock, padded)
INPUT_ARRAY(weightsBinding, WeightBlock, weights)
STATE_ARRAY(nextCellsBinding, NextBlock, newCells)
uniform ivec2 size;
uniform int rowItems;
uniform int paddedItems;
uniform int margin;
uniform float dt;
uniform vec4 growth[KERNELS];  // For each kernel: mu, the member perSigma2 of LeniaGrowth, weight, kind
uniform vec4 limits;  // Birth and survival limits of SmoothLife
uniform vec2 slopes;
#include "lenia/model.glsl"
const int reaches[2 * RANGE + 1] = int[](REACHES);
const int COLUMNS = 2 * RANGE + 4;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= rowItems || at.y >= size.y) return;
  int place = at.x + margin / 4;
  vec4 sums[KERNELS];
  for (int k = 0; k < KERNELS; ++k) sums[k] = vec4(0.0f);
  for (int row = 0; row <= 2 * RANGE; ++row) {
    int reach = reaches[row];
    int start = (at.y + row) * paddedItems + place;
    // The loop covers the elements that contain the cells from -reach to 3 + reach.
    for (int e = -reach >> 2; e <= 3 + reach >> 2; ++e) {
      vec4 four = LOAD_INPUT(padded, start + e);
      for (int i = 0; i < 4; ++i) {
        int c = 4 * e + i + RANGE;
        if (c < 0 || c >= COLUMNS) continue;
        for (int k = 0; k < KERNELS; ++k) {
          vec4 weight = LOAD_INPUT(weights, (k * (2 * RANGE + 1) + row) * COLUMNS + c);
          precise vec4 sum = sums[k] + weight * four[i];
          sums[k] = sum;
        }
      }
    }
  }
  vec4 here = LOAD_INPUT(padded, (at.y + RANGE) * paddedItems + place);
  vec4 next;
  for (int i = 0; i < 4; ++i) {
#ifdef SMOOTH_LIFE
    float wanted = smoothLifeNext(sums[0][i], sums[1][i], limits, slopes.x, slopes.y);
    precise float change = 2.0f * wanted - 1.0f;
#else
    precise float change = 0.0f;
    for (int k = 0; k < KERNELS; ++k) {
      LeniaGrowth g = LeniaGrowth(growth[k].x, growth[k].y, growth[k].z, int(growth[k].w));
      float grown = leniaGrowth(g, sums[k][i]);
      change = change + g.weight * grown;
    }
#endif
    precise float stepped = here[i] + dt * change;
    next[i] = at.x * 4 + i < size.x ? leniaHeld(stepped) : 0.0f;
  }
  STORE_STATE(newCells, at.y * rowItems + at.x, next);
}

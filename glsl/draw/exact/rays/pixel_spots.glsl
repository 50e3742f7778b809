// Spots of a pixel: its visible surface points that rays light later (spots.glsl). The samples of a pixel that show the
// same primitive share one spot. SAMPLES: samples per pixel. PAIRED: as in draw/exact/sample_read.glsl.
#include "draw/exact/view_block.glsl"
#include "draw/exact/sample_read.glsl"
#include "draw/exact/tiles/tile_lists.glsl"

// Returns the number of samples that show the same primitive as sample s. Returns 0 if an earlier sample shows the
// primitive or if the sample is empty.
int samplesShowing(int first, int s) {
  uint id = idAt(first + s);
  int same = 0;
  for (int other = 0; other < SAMPLES; ++other) {
    bool like = idAt(first + other) == id;
    if (like && other < s) return 0;
    same += like ? 1 : 0;
  }
  return id == emptyId ? 0 : same;
}

// Returns the number of the pixel's `rays` that a spot gets if `same` samples show it.
int raysOf(int same, int rays) {
  return max((rays * same + SAMPLES - 1) / SAMPLES, 1);
}

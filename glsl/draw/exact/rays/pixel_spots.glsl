// Which of a pixel's samples are spots. SAMPLES, PAIRED.
#include "draw/exact/view_block.glsl"
#include "draw/exact/sample_read.glsl"
#include "draw/exact/tiles/tile_lists.glsl"

// Samples of the pixel that show what sample s is the first to show; 0 where it is not the first, or shows nothing.
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

// Of the pixel's rays, those of a spot that so many samples show.
int raysOf(int same, int rays) {
  return max((rays * same + SAMPLES - 1) / SAMPLES, 1);
}

// Light of a tile: each primitive of a pixel once. Whoever includes it has vec4 lightOf(pixel, number, first sample).
//
// Software drivers compute a vector of invocations for as long as one of them has something to do, and pixels show one to four
// primitives. So there an invocation takes one primitive after the other of all its pixels, and is hardly ever idle.
//
// REFLECTED: what reflections change is found once for the four pixels of a half pixel, of each part of the thing at the first sample
// that shows it: uint partOfThing(number) says which belong together.
#if defined REFLECTED && !defined GROUND_BELOW
// Nothing is lit but the ground that mirrors show.
#undef SHADOW
#undef LAMPS
#endif
#include "draw/exact/tiles/shaded_tile.glsl"

vec4 lightOf(ivec2 pixel, uint number, int firstSample);

// The sample of these whose primitive is next: light adds up surface by surface, and of each by samples.
int firstToLight(PixelIds shown, int left) {
#ifdef JOINED
  uint least = emptyId;
  for (int s = 0; s < SAMPLES; ++s) least = (left >> s & 1) != 0 ? min(least, shown.of[s]) : least;
  int owner = ownerOf(least), first = 0;
  for (int s = SAMPLES - 1; s >= 0; --s)
    if ((left >> s & 1) != 0 && (shown.of[s] == least || ownerOf(shown.of[s]) == owner)) first = s;
  return first;
#else
  return findLSB(left);
#endif
}

#ifdef REFLECTED
#include "draw/exact/tiles/half_tile.glsl"
uint partOfThing(uint number);

// A bit for each sample of these that shows that part.
int samplesOfPart(PixelIds shown, int left, uint part) {
  int same = 0;
  for (int s = 0; s < SAMPLES; ++s) same |= (left >> s & 1) != 0 && partOfThing(shown.of[s]) == part ? 1 << s : 0;
  return same;
}
#endif

// Of what has `numbers` numbers from firstId on.
#ifdef REFLECTED
void lightTile(uint firstId, uint numbers) {
  ivec2 corner = tileToShade();
  if (corner.x < 0) return;
  for (int i = int(gl_LocalInvocationIndex); i < halfPixels; i += 64 / ROWS) {
    ivec4 left = ivec4(0);
    for (int k = 0; k < 4; ++k) {
      ivec2 pixel = pixelOfHalf(corner, i, k);
      if (inPicture(pixel)) left[k] = samplesOf(idsOf(pixel), firstId, numbers);
    }
    while ((left.x | left.y | left.z | left.w) != 0) {
      uint least = emptyId;
      for (int k = 0; k < 4; ++k) {
        if (left[k] == 0) continue;
        PixelIds shown = idsOf(pixelOfHalf(corner, i, k));
        for (int s = 0; s < SAMPLES; ++s) least = (left[k] >> s & 1) != 0 ? min(least, shown.of[s]) : least;
      }
      ivec4 same = ivec4(0);
      uint part = partOfThing(least);
      for (int k = 0; k < 4; ++k)
        if (left[k] != 0) same[k] = samplesOfPart(idsOf(pixelOfHalf(corner, i, k)), left[k], part);
      int k = firstOf(same), s = findLSB(same[k]);
      ivec2 pixel = pixelOfHalf(corner, i, k);
      addToHalf(corner, i, lightOf(pixel, idAt(pixel, s) - firstId, s), same);
      left &= ~same;
    }
  }
}
#elif ROWS == 1
void lightTile(uint firstId, uint numbers) {
  ivec2 corner = tileToShade(), pixel = pixelOf(corner, 0);
  if (corner.x < 0 || !inPicture(pixel)) return;
  PixelIds shown = idsOf(pixel);
  vec4 sum = imageLoad(sums, pixel);
  for (int left = samplesOf(shown, firstId, numbers); left != 0;) {
    int first = firstToLight(shown, left), same = samplesLike(shown, first);
    sum = withLight(pixel, sum, lightOf(pixel, idAt(pixel, first) - firstId, first), same);
    left &= ~same;
  }
  imageStore(sums, pixel, sum);
}
#else
void lightTile(uint firstId, uint numbers) {
  const int together = min(ROWS, 32 / SAMPLES);  // pixels, a bit a sample
  ivec2 corner = tileToShade();
  if (corner.x < 0) return;
  for (int begin = 0; begin < ROWS; begin += together) {
    int left = 0;
    for (int i = 0; i < together; ++i) {
      ivec2 pixel = pixelOf(corner, begin + i);
      if (inPicture(pixel)) left |= samplesOf(idsOf(pixel), firstId, numbers) << (i * SAMPLES);
    }
    while (left != 0) {
      int i = findLSB(left) / SAMPLES;
      ivec2 pixel = pixelOf(corner, begin + i);
      PixelIds shown = idsOf(pixel);
      int first = firstToLight(shown, left >> (i * SAMPLES) & ((1 << SAMPLES) - 1));
      int same = samplesLike(shown, first);
      vec4 light = lightOf(pixel, idAt(pixel, first) - firstId, first);
      addLight(pixel, light, same);
      left &= ~(same << (i * SAMPLES));
    }
  }
}
#endif

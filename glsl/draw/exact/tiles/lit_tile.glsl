// Shades the pixels of a tile; each primitive of a pixel is shaded once. The including file declares vec4
// lightOf(pixel, number, first sample).
// On a software driver, a vector of invocations runs as long as any of them has work, and a pixel shows one to four
// primitives. Therefore an invocation handles the primitives of all its pixels one after another, so that it is rarely
// idle. REFLECTED: the change by reflections is computed once for each half pixel (four pixels) and each part of the
// object, at the first sample that shows the part. uint partOfThing(number) returns the part to which a primitive
// belongs.
#if defined REFLECTED && !defined GROUND_BELOW
// Only the ground in mirrors is shaded here; it needs neither shadow maps nor lamps.
#undef SHADOW
#undef LAMPS
#endif
#include "draw/exact/tiles/shaded_tile.glsl"

vec4 lightOf(ivec2 pixel, uint number, int firstSample);

// Returns the sample from the mask `left` whose primitive is shaded next. The order is by surface, then by sample, so
// that the light is summed in a fixed order.
int firstToLight(PixelIds shown, int left) {
#ifdef JOINED
  uint minimum = emptyId;
  for (int s = 0; s < SAMPLES; ++s) minimum = (left >> s & 1) != 0 ? min(minimum, shown.of[s]) : minimum;
  int owner = ownerOf(minimum), first = 0;
  for (int s = SAMPLES - 1; s >= 0; --s)
    if ((left >> s & 1) != 0 && (shown.of[s] == minimum || ownerOf(shown.of[s]) == owner)) first = s;
  return first;
#else
  return findLSB(left);
#endif
}

#ifdef REFLECTED
#include "draw/exact/tiles/half_tile.glsl"
uint partOfThing(uint number);

// Returns the mask of the samples from `left` that show the part.
int samplesOfPart(PixelIds shown, int left, uint part) {
  int same = 0;
  for (int s = 0; s < SAMPLES; ++s) same |= (left >> s & 1) != 0 && partOfThing(shown.of[s]) == part ? 1 << s : 0;
  return same;
}
#endif

// Shades the primitives with the ids firstId to firstId + numbers - 1.
#ifdef REFLECTED
void lightTile(uint firstId, uint numbers) {
  ivec2 corner = tileToShade();
  if (corner.x < 0) return;
  int traced = halfPixelsToTrace(corner);
  for (int ray = int(gl_LocalInvocationIndex); ray < raysToTrace(traced); ray += 64 / ROWS) {
    ivec2 item = rayToTrace(traced, ray);
    int i = item.x;
    ivec4 left = ivec4(0);
    for (int k = 0; k < 4; ++k) {
      ivec2 pixel = pixelOfHalf(corner, i, k);
      if (inPicture(pixel) && (item.y >> k & 1) != 0) left[k] = samplesOf(idsOf(pixel), firstId, numbers);
    }
    while ((left.x | left.y | left.z | left.w) != 0) {
      uint minimum = emptyId;
      for (int k = 0; k < 4; ++k) {
        if (left[k] == 0) continue;
        PixelIds shown = idsOf(pixelOfHalf(corner, i, k));
        for (int s = 0; s < SAMPLES; ++s) minimum = (left[k] >> s & 1) != 0 ? min(minimum, shown.of[s]) : minimum;
      }
      ivec4 same = ivec4(0);
      uint part = partOfThing(minimum);
      for (int k = 0; k < 4; ++k)
        if (left[k] != 0) same[k] = samplesOfPart(idsOf(pixelOfHalf(corner, i, k)), left[k], part);
      int k = firstOf(same), s = findLSB(same[k]);
      ivec2 pixel = pixelOfHalf(corner, i, k);
      addToHalf(corner, i, lightOf(pixel, idAt(pixel, s) - firstId, s), same, firstId + part);
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
  const int together = min(ROWS, 32 / SAMPLES);  // pixels per round; the mask of a round has one bit per sample
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

// Light of a tile: pairs of a pixel and a primitive that it shows are listed first and then lit one after the other, so that
// no invocation waits for pixels that show more of them; each pixel adds up its own in the order of its samples. Whoever
// includes it has vec3 lightOf(pixel, number, first sample). Listing costs about a tenth of a plain surface's light: for those
// whose light is dear.
#include "draw/exact/tiles/shaded_tile.glsl"
const int tilePixels = tileSide * tileSide;
shared uint pairCount;
shared uint pairs[tilePixels * SAMPLES];      // pixel in the lowest bits, then the first of its samples
shared vec3 lightOfPair[tilePixels * SAMPLES];  // by first sample, then by pixel

vec3 lightOf(ivec2 pixel, uint number, int firstSample);

// Of the tile's pixels, of what has `numbers` numbers from firstId on.
void lightTile(uint firstId, uint numbers) {
  ivec2 corner = tileToShade();
  if (corner.x < 0) return;
  int me = int(gl_LocalInvocationIndex);
  ivec2 pixel = corner + inTile();
  if (me == 0) pairCount = 0u;
  barrier();
  PixelIds shown;
  int shows = 0;
  if (inPicture(pixel)) {
    shown = idsOf(pixel);
    shows = samplesOf(shown, firstId, numbers);
  }
  for (int left = shows; left != 0;) {
    int first = findLSB(left);
    pairs[atomicAdd(pairCount, 1u)] = uint(me | first << 6);
    left &= ~samplesLike(shown, first);
  }
  barrier();
  int count = int(pairCount);  // once: software drivers read shared memory lane by lane
  for (int i = me; i < count; i += tilePixels) {
    int pair = int(pairs[i]), first = pair >> 6, at = pair & (tilePixels - 1);
    ivec2 lit = corner + placeInTile(at);
    lightOfPair[first * tilePixels + at] = lightOf(lit, idAt(lit, first) - firstId, first);
  }
  barrier();
  if (shows == 0) return;
  vec4 sum = imageLoad(sums, pixel);
  for (int left = shows; left != 0;) {
    int first = findLSB(left), same = samplesLike(shown, first);
    sum = withLight(sum, vec4(lightOfPair[first * tilePixels + me], 1.0f), bitCount(same));
    left &= ~same;
  }
  imageStore(sums, pixel, sum);
}

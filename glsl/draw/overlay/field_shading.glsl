// Draws a field in the picture. Each pixel is the exact mean of the cells under it, so the edges of cells are
// antialiased and nothing shimmers during a zoom. If a pixel covers less than a cell, values are averaged over a box of
// one cell around the pixel, which equals linear interpolation. Smooth fields (`splined`) are averaged over such a box a
// second time, which gives a quadratic spline without creases at the cells. With `colored`, the light of cells is
// averaged; otherwise, values are averaged and the mean is coloured. Reads the uniforms of field_view.glsl. Compiles as
// GLSL and as C++, after field_values.glsl and film.glsl.

// Returns one element (cell or texel). With `colored`, rgb is the light. a is the position of the value in the range (0
// to 1).
FUNCTION vec4 element(ivec2 place) {
  ivec2 at = tiled ? (place + 64 * size) % size : clamp(place, ivec2(0), size - 1);
  if (reduces) return colored ? reducedAt(at) : vec4(placeOf(reducedAt(at).x));
  float value = valueOf(at);
  return colored ? vec4(colorOfCell(at, value), placeOf(value)) : vec4(placeOf(value));
}

// Returns the mean over a rectangle. Each element is weighted by the part of its area inside the rectangle.
FUNCTION vec4 meanOfAll(vec2 from, vec2 to) {
  ivec2 first = ivec2(floor(from)), last = max(ivec2(ceil(to)) - 1, first);
  ROUNDED vec4 sum = vec4(0.0f);
  for (int y = first.y; y <= last.y; ++y) {
    ROUNDED float tall = min(to.y, float(y + 1)) - max(from.y, float(y));
    tall = tall < 1e-9f ? 0.0f : tall;  // set to zero to avoid subnormal products
    for (int x = first.x; x <= last.x; ++x) {
      ROUNDED float wide = min(to.x, float(x + 1)) - max(from.x, float(x));
      wide = wide < 1e-9f ? 0.0f : wide;
      sum = sum + element(base + ivec2(x, y)) * (tall * wide);
    }
  }
  ROUNDED float area = (to.x - from.x) * (to.y - from.y);
  ROUNDED vec4 mean = sum * inverse(area);
  return mean;
}

// Returns the same mean as meanOfAll() for a box of one element; used if the field is magnified. The box overlaps at
// most two elements per axis, because rounding never moves an edge past the next whole number. The code needs no loops
// and gives the same bits as meanOfAll(), because an element outside the box adds zero.
FUNCTION vec4 meanOfTwo(vec2 from, vec2 to) {
  ivec2 first = ivec2(floor(from));
  ROUNDED float left = min(to.x, float(first.x + 1)) - max(from.x, float(first.x));
  ROUNDED float right = min(to.x, float(first.x + 2)) - max(from.x, float(first.x + 1));
  ROUNDED float top = min(to.y, float(first.y + 1)) - max(from.y, float(first.y));
  ROUNDED float bottom = min(to.y, float(first.y + 2)) - max(from.y, float(first.y + 1));
  left = left < 1e-9f ? 0.0f : left;
  right = right < 1e-9f ? 0.0f : right;
  top = top < 1e-9f ? 0.0f : top;
  bottom = bottom < 1e-9f ? 0.0f : bottom;
  ivec2 at = base + first;
  ROUNDED vec4 sum = element(at) * (top * left);
  sum = sum + element(at + ivec2(1, 0)) * (top * right);
  sum = sum + element(at + ivec2(0, 1)) * (bottom * left);
  sum = sum + element(at + ivec2(1, 1)) * (bottom * right);
  ROUNDED float area = (to.x - from.x) * (to.y - from.y);
  ROUNDED vec4 mean = sum * inverse(area);
  return mean;
}

FUNCTION vec4 meanOver(vec2 from, vec2 to) {
  return magnified ? meanOfTwo(from, to) : meanOfAll(from, to);
}

// Returns the weights of the elements before, at and after a position: linear interpolation averaged over a box of one
// element. `beyond` is the offset of the position from the centre of the middle element, -1/2 to 1/2.
FUNCTION vec3 splineWeights(float beyond) {
  ROUNDED float before = 0.5f - beyond;
  ROUNDED float after = 0.5f + beyond;
  before = before < 1e-3f ? 0.0f : before;  // set to zero to avoid subnormal products
  after = after < 1e-3f ? 0.0f : after;
  ROUNDED vec3 weights = vec3(0.5f * (before * before), 0.75f - beyond * beyond, 0.5f * (after * after));
  return weights;
}

FUNCTION vec4 splineRow(ivec2 at, vec3 weights) {
  ROUNDED vec4 sum = element(at - ivec2(1, 0)) * weights.x + element(at) * weights.y + element(at + ivec2(1, 0)) * weights.z;
  return sum;
}

FUNCTION vec4 splineAt(vec2 place) {
  ivec2 at = ivec2(floor(place));
  ROUNDED vec2 beyond = place - vec2(at) - 0.5f;
  vec3 across = splineWeights(beyond.x), down = splineWeights(beyond.y);
  ivec2 middle = base + at;
  ROUNDED vec4 sum = splineRow(middle - ivec2(0, 1), across) * down.x + splineRow(middle, across) * down.y +
                     splineRow(middle + ivec2(0, 1), across) * down.z;
  return sum;
}

// Returns the colour of a pixel, averaged over `middle` +- `reach`. Between half an element and one element per pixel,
// the result changes gradually from the spline to the mean.
FUNCTION vec4 seenAround(vec2 middle, vec2 reach) {
  if (fine && splined) return splineAt(middle);
  ROUNDED float coarse = 2.0f * max(perPixel.x, perPixel.y) - 1.0f;
  float share = splined ? clamp(coarse, 0.0f, 1.0f) : 1.0f;
  vec4 mean = vec4(0.0f), spline = vec4(0.0f);
  if (share > 0.0f) {
    ROUNDED vec2 a = middle - reach;
    ROUNDED vec2 b = middle + reach;
    mean = meanOver(a, b);
  }
  if (share >= 1.0f) return mean;
  spline = splineAt(middle);
  ROUNDED vec4 both = spline + (mean - spline) * share;
  return share > 0.0f ? both : spline;
}

// Returns the fraction of the interval from..to that is inside low..high.
FUNCTION float shareIn(float from, float to, float low, float high) {
  ROUNDED float length_ = to - from;
  ROUNDED float share = (min(to, high) - max(from, low)) * inverse(max(length_, 1e-7f));
  return clamp(share, 0.0f, 1.0f);
}

// Returns x^24. Below 2^-5, where the power is negligible, x is replaced by 2^-5.
FUNCTION float power24(float x) {
  float held = max(x, 0.03125f);
  ROUNDED float x3 = held * held * held;
  ROUNDED float x6 = x3 * x3;
  ROUNDED float x12 = x6 * x6;
  ROUNDED float x24 = x12 * x12;
  return x24;
}

FUNCTION float exponential(float x) {
  ROUNDED float doublings = x * 1.44269504f;
  return powerOfTwo(doublings);
}

// Shades a field as a relief under a soft light from the top left, with the highlight of a polished surface. Flat areas
// keep their colour. The light comes from (-0.55, -0.65, 0.75). The constants below are the unit vector of that
// direction, and the unit half vector between it and the direction to the eye.
FUNCTION vec3 lit(vec3 color, vec2 middle, vec2 reach) {
  ROUNDED vec2 a = middle - reach;
  ROUNDED vec2 b = middle + reach;
  ROUNDED vec2 separation = 2.0f * reach;
  ROUNDED vec2 twice = 2.0f * separation;
  vec2 right = vec2(separation.x, 0.0f), down = vec2(0.0f, separation.y);
  ROUNDED vec2 a1 = a + right;
  ROUNDED vec2 b1 = b + right;
  ROUNDED vec2 a2 = a - right;
  ROUNDED vec2 b2 = b - right;
  ROUNDED vec2 a3 = a + down;
  ROUNDED vec2 b3 = b + down;
  ROUNDED vec2 a4 = a - down;
  ROUNDED vec2 b4 = b - down;
  ROUNDED float riseX = (meanOver(a1, b1).w - meanOver(a2, b2).w) * inverse(twice.x);
  ROUNDED float riseY = (meanOver(a3, b3).w - meanOver(a4, b4).w) * inverse(twice.y);
  if (splined) {
    ROUNDED vec2 after = middle + right;
    ROUNDED vec2 before = middle - right;
    ROUNDED vec2 below = middle + down;
    ROUNDED vec2 above = middle - down;
    riseX = seenAround(after, reach).w - seenAround(before, reach).w;
    riseY = seenAround(below, reach).w - seenAround(above, reach).w;
    riseX = riseX * inverse(twice.x);
    riseY = riseY * inverse(twice.y);
  }
  ROUNDED vec3 up = vec3(-slope.x * riseX, -slope.y * riseY, 1.0f);
  vec3 normal = unitOf(up);
  ROUNDED float facing = dotted(normal, vec3(-0.484717914f, -0.572848444f, 0.660978974f)) * 1.51290743f;
  ROUNDED float beyond = 1.0f - max(facing, 1.0f);
  ROUNDED float brighter = 1.45f - 0.45f * exponential(beyond);
  ROUNDED float even = 0.16f + 0.84f * facing;
  ROUNDED float darker = 0.16f * exponential(facing);
  float diffuse = facing > 1.0f ? brighter : max(even, darker);
  // Broad highlight. It is fainter on dark colours, because it would draw thin lines there.
  float mirrored = dotted(normal, vec3(-0.265945108f, -0.314298764f, 0.911311959f));
  ROUNDED float shine = power24(mirrored) - 0.107648918f;
  float gleam = max(shine, 0.0f);
  float brightness = dotted(color, vec3(0.2126f, 0.7152f, 0.0722f));
  ROUNDED vec3 seen = color * diffuse + gleam * (0.02f + 0.3f * root(brightness) * vec3(1.0f, 0.97f, 0.92f));
  return seen;
}

// Returns the colour of pixel `at` (counted from the top left), premultiplied by the opacity, and the opacity.
FUNCTION vec4 fieldPixel(ivec2 at) {
  ROUNDED vec2 from = start + perPixel * vec2(at);
  ROUNDED vec2 to = from + perPixel;
  ROUNDED vec2 halfway = 0.5f * (from + to);
  vec2 middle = clamp(halfway, -3e7f, 3e7f);
  // Averages over at most 80 elements per side. If a small field repeats many times within a pixel, this is enough.
  ROUNDED vec2 reach = 0.5f * clamp(perPixel, vec2(colored && !splined ? 1e-5f : 1.0f), vec2(40.0f));
  float inside = 1.0f;
  if (!tiled) {
    vec2 low = vec2(-base), high = vec2(size - base);
    ROUNDED float share = shareIn(from.x, to.x, low.x, high.x) * shareIn(from.y, to.y, low.y, high.y);
    inside = share;
  }
  vec3 color = border;
  if (inside > 0.0f) {
    vec4 mean = seenAround(middle, reach);
    vec3 own = colored ? vec3(mean) : colorAtPlace(mean.w);
    if (relief) own = lit(own, middle, max(reach, vec2(0.5f)));
    color = blend(border, own, inside);
  }
  if (encodes) color = encoded(clamp(color, 0.0f, 1.0f));
  ROUNDED vec3 through = color * opacity;
  return vec4(through, opacity);
}

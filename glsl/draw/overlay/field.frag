// A field on the picture: each pixel is the exact average over the cells under it, so edges of cells are
// smooth, nothing aliases and nothing shimmers while it zooms. Where a pixel covers less than a cell, values
// are averaged over one whole cell around it instead, which is linear interpolation.
// COLORED: averages the light of cells; else values, coloured afterwards. REDUCED: reads a texture of averaged
// blocks. RELIEF: shaded as if lit. OVER: encoded for the finished picture; else light.
#include "draw/overlay/field_cells.glsl"
#include "draw/overlay/field_colors.glsl"
#include "draw/screen/film.glsl"
#ifdef REDUCED
layout(binding = reducedUnit) uniform sampler2D reduced;
#endif
uniform vec2 picture;    // pixels
uniform bool topFirst;   // row 0 of the target is the picture's top row
uniform ivec2 size;      // elements: cells, or texels of `reduced`
uniform ivec2 base;      // pixel p covers the elements from base + start + perPixel p to + perPixel (p + 1)
uniform vec2 start;
uniform vec2 perPixel;
uniform bool tiled;
uniform vec3 border;
uniform float opacity;
uniform vec2 slope;      // height of the whole range in elements, along x and y
layout(location = 0) out vec4 pixel;

/// Light in rgb where COLORED; the value's place in the range in a.
vec4 element(ivec2 at) {
  at = tiled ? (at + 64 * size) % size : clamp(at, ivec2(0), size - 1);
#ifdef REDUCED
#ifdef COLORED
  return texelFetch(reduced, at, 0);
#else
  return vec4(placeOf(texelFetch(reduced, at, 0).r));
#endif
#else
  float value = valueOf(at);
#ifdef COLORED
  return vec4(colorOf(value), placeOf(value));
#else
  return vec4(placeOf(value));
#endif
#endif
}

/// Mean over a rectangle, each element by the area it has in it.
vec4 meanOver(vec2 from, vec2 to) {
  ivec2 first = ivec2(floor(from)), last = max(ivec2(ceil(to)) - 1, first);
  vec4 sum = vec4(0.0);
  for (int y = first.y; y <= last.y; ++y) {
    float tall = min(to.y, float(y + 1)) - max(from.y, float(y));
    for (int x = first.x; x <= last.x; ++x) {
      float wide = min(to.x, float(x + 1)) - max(from.x, float(x));
      sum += tall * wide * element(base + ivec2(x, y));
    }
  }
  return sum / ((to.x - from.x) * (to.y - from.y));
}

/// Fraction of the interval from..to that lies in low..high.
float shareIn(float from, float to, float low, float high) {
  return clamp((min(to, high) - max(from, low)) / (to - from), 0.0, 1.0);
}

#ifdef RELIEF
/// A soft light from the top left, and what of it a polished surface mirrors. Flat ground keeps its colour.
vec3 lit(vec3 color, vec2 middle, vec2 reach) {
  vec2 a = middle - reach, b = middle + reach;
  vec2 right = vec2(2.0 * reach.x, 0.0), down = vec2(0.0, 2.0 * reach.y);
  vec2 rise = vec2(meanOver(a + right, b + right).a - meanOver(a - right, b - right).a,
                   meanOver(a + down, b + down).a - meanOver(a - down, b - down).a) / (4.0 * reach);
  vec3 normal = normalize(vec3(-slope * rise, 1.0));
  const vec3 light = normalize(vec3(-0.55, -0.65, 0.75));
  const vec3 halfway = normalize(light + vec3(0.0, 0.0, 1.0));
  float facing = dot(normal, light) / light.z;
  float diffuse = facing > 1.0 ? 1.0 + 0.45 * (1.0 - exp(1.0 - facing)) : max(0.16 + 0.84 * facing, 0.16 * exp(facing));
  // Broad, and fainter on dark colours, where it would draw thin lines.
  float shine = pow(max(dot(normal, halfway), 0.0), 24.0) - pow(halfway.z, 24.0);
  float brightness = dot(color, vec3(0.2126, 0.7152, 0.0722));
  return color * diffuse + max(shine, 0.0) * (0.02 + 0.3 * sqrt(brightness) * vec3(1.0, 0.97, 0.92));
}
#endif

void main() {
  vec2 at = vec2(gl_FragCoord.x, topFirst ? gl_FragCoord.y : picture.y - gl_FragCoord.y) - 0.5;
  vec2 from = start + perPixel * at, to = from + perPixel, middle = 0.5 * (from + to);
  // Where a small field is repeated many times in a pixel, part of them will do.
#ifdef COLORED
  vec2 reach = 0.5 * min(perPixel, vec2(40.0));
#else
  vec2 reach = 0.5 * clamp(perPixel, vec2(1.0), vec2(40.0));
#endif
  float inside = 1.0;
  if (!tiled) {
    vec2 low = vec2(-base), high = vec2(size - base);
    inside = shareIn(from.x, to.x, low.x, high.x) * shareIn(from.y, to.y, low.y, high.y);
  }
  vec3 color = border;
  if (inside > 0.0) {
    vec4 mean = meanOver(middle - reach, middle + reach);
#ifdef COLORED
    vec3 own = mean.rgb;
#else
    vec3 own = colorAtPlace(mean.a);
#endif
#ifdef RELIEF
    own = lit(own, middle, max(reach, vec2(0.5)));
#endif
    color = mix(border, own, inside);
  }
#ifdef OVER
  color = encoded(clamp(color, 0.0, 1.0));
#endif
  pixel = vec4(color * opacity, opacity);
}

// Values that surfaces show instead of light. SHOWN: 1 the normal, 2 the base colour, 3 texture coordinates, and as the
// colours of overlays 4 edges, 5 normals, 6 texture coordinates, 7 objects. Compiles as GLSL and as C++.
#ifndef DRAW_OVERLAY
#define DRAW_OVERLAY
#include "draw/arithmetic.glsl"

// Returns the colour under a lamp at the eye, which shows the shape.
FUNCTION vec3 facingColor(vec3 base, vec3 normal, vec3 view) {
  ROUNDED float facing = 0.25f + 0.75f * min(abs(dotted(normal, view)), 1.0f);
  ROUNDED vec3 color = base * facing;
  return color;
}

// Returns the linear light of an encoded value (IEC 61966-2-1).
FUNCTION float lightOfEncoded(float x) {
  ROUNDED float low = x * 0.0773993808f;
  ROUNDED float high = (x + 0.055f) * 0.947867299f;
  ROUNDED float doublings = 2.4f * logarithmOfTwo(max(high, 1e-6f));
  return x <= 0.04045f ? low : powerOfTwo(doublings);
}

// Returns the light that a picture encodes as 0.5 + 0.5 n.
FUNCTION vec3 normalColor(vec3 n) {
  ROUNDED vec3 x = clamp(0.5f + 0.5f * n, 0.0f, 1.0f);
  return vec3(lightOfEncoded(x.x), lightOfEncoded(x.y), lightOfEncoded(x.z));
}

// Returns the base colour with the edges of the triangle. w: barycentric weights at the pixel; right, above: weights one
// pixel to the right and above. Triangles of a few pixels have fainter edges, and the edges of still smaller ones, which no pixel can show,
// become an even darker tone.
FUNCTION vec3 edgedColor(vec3 base, vec3 w, vec3 right, vec3 above) {
  ROUNDED vec3 x = right - w;
  ROUNDED vec3 y = above - w;
  ROUNDED vec3 square = x * x + y * y;
  vec3 height = vec3(inverseRoot(max(square.x, 1e-12f)), inverseRoot(max(square.y, 1e-12f)),
                     inverseRoot(max(square.z, 1e-12f)));  // pixels from an edge to the opposite corner
  ROUNDED vec3 away = w * height;
  ROUNDED float line = clamp(1.1f - min(away.x, min(away.y, away.z)), 0.0f, 1.0f);
  float small_ = min(height.x, min(height.y, height.z));
  ROUNDED float strength = clamp(0.15f * small_, 0.25f, 1.0f);
  ROUNDED float seen_ = clamp(0.6f * small_ - 1.0f, 0.0f, 1.0f);  // 0: the mean of the lines, 1: single lines
  ROUNDED float share = (0.8f + seen_ * (line - 0.8f)) * strength;
  ROUNDED float bright = 0.2126f * base.x + 0.7152f * base.y + 0.0722f * base.z;
  vec3 edge = bright > 0.1f ? vec3(0.004f) : vec3(0.6f);
  ROUNDED vec3 color = base + share * (edge - base);
  return color;
}

// Returns -1 in the squares 0, 2, ... and 1 in the squares 1, 3, ..., with an edge one pixel wide. x: position in
// squares; change: its change per pixel.
FUNCTION float squareSide(float x, float change) {
  ROUNDED float half_ = 0.5f * x + 0.25f;
  ROUNDED float wave = abs(2.0f * (half_ - floor(half_)) - 1.0f) - 0.5f;
  ROUNDED float side = 2.0f * wave * inverse(max(change, 1e-6f));
  return clamp(side, -1.0f, 1.0f);
}

// Returns a checker of 8 by 8 squares over uv 0 to 1, red along u and green along v. across, up: changes of uv per pixel.
FUNCTION vec3 checkerColor(vec2 uv, vec2 across, vec2 up) {
  ROUNDED vec2 change = 8.0f * (vec2(abs(across.x), abs(across.y)) + vec2(abs(up.x), abs(up.y)));
  ROUNDED vec2 at = 8.0f * uv;
  ROUNDED float check = squareSide(at.x, change.x) * squareSide(at.y, change.y);
  ROUNDED float bright = 0.55f + 0.35f * check;
  ROUNDED vec2 place = uv - vec2(floor(uv.x), floor(uv.y));
  ROUNDED vec3 color = vec3(0.08f + 0.92f * place.x, 0.08f + 0.92f * place.y, 0.35f) * bright;
  return color;
}

#ifdef SHOWN
FUNCTION vec3 shownValue(vec3 base, vec3 normal, vec3 view) {
#if SHOWN == 1
  return normal;
#elif SHOWN <= 3
  return base;
#elif SHOWN == 5
  return normalColor(normal);
#else
  return facingColor(base, normal, view);
#endif
}
#endif
#endif

// Calls the functions of overlays with weights and texture coordinates of all kinds, also on edges.
FUNCTION vec4 asked(int i) {
  vec3 a = somePlace(i, 0), b = somePlace(i, 1), c = somePlace(i, 2);
  int what = i % 4;
  if (what == 0) return vec4(facingColor(0.5f + 0.5f * a, b, c), lightOfEncoded(abs(a.x)));
  if (what == 1) return vec4(normalColor(a), squareSide(9.0f * b.x, 0.25f * abs(c.x)));
  if (what == 2) return vec4(edgedColor(0.5f + 0.5f * a, abs(b), b + 0.125f * c, b + 0.0625f * a), 0.0f);
  return vec4(checkerColor(vec2(3.0f * a.x, 2.0f * a.y), 0.0625f * vec2(b.x, b.y), 0.0625f * vec2(c.x, c.y)), 0.0f);
}

// Shades a small sprite. GLOW: a soft round glow with alpha 0, because the light adds to everything behind it,
// including the sky. Otherwise: a square that represents a lit ball.
flat in vec3 light;
flat in vec2 slope;
#ifdef POINT
#define ACROSS (gl_PointCoord * vec2(2, -2) + vec2(-1, 1))
#else
in vec2 across;
#define ACROSS across
#endif
layout(location = 0) out vec4 radiance;

void main() {
  vec2 place = ACROSS;
#ifdef GLOW
  float inside = max(1.0 - dot(place, place), 0.0);
  radiance = vec4(light * (inside * inside), 0.0);
#else
  radiance = vec4(light * max(1.0 + dot(place, slope), 0.0), 1.0);
#endif
}

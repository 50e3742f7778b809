// Shades a soft round glow. Alpha is 0 because the light adds to everything behind it, including the sky.
flat in vec3 tint;
in vec2 across;
layout(location = 0) out vec4 radiance;

void main() {
  float inside = max(1.0 - dot(across, across), 0.0);
  radiance = vec4(tint * (inside * inside), 0.0);
}

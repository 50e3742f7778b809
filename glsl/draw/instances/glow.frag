// Soft and round. Alpha 0: light that adds to what is behind it, sky included.
flat in vec3 tint;
in vec2 across;
layout(location = 0) out vec4 radiance;

void main() {
  float inside = max(1.0 - dot(across, across), 0.0);
  radiance = vec4(tint * (inside * inside), 0.0);
}

in vec3 shade;
layout(location = 0) out vec4 radiance;

void main() {
  radiance = vec4(shade, 1.0);
}

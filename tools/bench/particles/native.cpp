// The plain all-pairs loop, compiled for the machine's instruction set (-O3 -march=native). Without
// -ffast-math, sums keep the order of the source.
#include <cmath>

void nativePairs(const float* bodies, float* accelerations, int count, int first, int end, float gravity,
                 float softening);

void nativePairs(const float* bodies, float* accelerations, int count, int first, int end, float gravity,
                 float softening) {
  for (int i = first; i < end; ++i) {
    const float* here = bodies + 4 * i;
    float x = 0;
    float y = 0;
    float z = 0;
    for (int j = 0; j < count; ++j) {
      const float* body = bodies + 4 * j;
      const float dx = body[0] - here[0];
      const float dy = body[1] - here[1];
      const float dz = body[2] - here[2];
      const float inverse = 1.0F / std::sqrt(dx * dx + dy * dy + dz * dz + softening * softening);
      const float pull = body[3] * inverse * inverse * inverse;
      x += dx * pull;
      y += dy * pull;
      z += dz * pull;
    }
    float* out = accelerations + 4 * i;
    out[0] = x * gravity;
    out[1] = y * gravity;
    out[2] = z * gravity;
    out[3] = 0;
  }
}

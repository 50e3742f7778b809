// All-pairs gravity with one array per coordinate. With -Ofast -march=native, the compiler may reorder sums
// and vectorises the loop over the bodies.
void soaPairs(const float* x, const float* y, const float* z, const float* mass, int count, int first,
              int end, float softening, float* sums);

void soaPairs(const float* x, const float* y, const float* z, const float* mass, int count, int first,
              int end, float softening, float* sums) {
  for (int i = first; i < end; ++i) {
    float sumX = 0;
    float sumY = 0;
    float sumZ = 0;
    for (int j = 0; j < count; ++j) {
      const float dx = x[j] - x[i];
      const float dy = y[j] - y[i];
      const float dz = z[j] - z[i];
      const float squared = dx * dx + dy * dy + dz * dz + softening * softening;
      const float inverse = 1.0F / __builtin_sqrtf(squared);
      const float pull = mass[j] * inverse * inverse * inverse;
      sumX += dx * pull;
      sumY += dy * pull;
      sumZ += dz * pull;
    }
    sums[3 * i] = sumX;
    sums[3 * i + 1] = sumY;
    sums[3 * i + 2] = sumZ;
  }
}

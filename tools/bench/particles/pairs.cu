// A plain CUDA kernel for comparison. Each thread computes the acceleration of one body. A thread block loads the
// attracting bodies into shared memory tile by tile.
#include <algorithm>
#include <cuda_runtime.h>

namespace {

constexpr int tileBodies = 256;

__global__ void pairsKernel(const float4* bodies, float4* accelerations, int count, float gravity,
                            float softeningSquared) {
  __shared__ float4 tile[tileBodies];
  const int i = blockIdx.x * tileBodies + threadIdx.x;
  const float4 here = bodies[min(i, count - 1)];
  float x = 0, y = 0, z = 0;
  for (int start = 0; start < count; start += tileBodies) {
    const int j = start + threadIdx.x;
    tile[threadIdx.x] = j < count ? bodies[j] : make_float4(0, 0, 0, 0);
    __syncthreads();
#pragma unroll 16
    for (int k = 0; k < tileBodies; ++k) {
      const float4 body = tile[k];
      const float dx = body.x - here.x, dy = body.y - here.y, dz = body.z - here.z;
      const float inverse = rsqrtf(dx * dx + dy * dy + dz * dz + softeningSquared);
      const float pull = body.w * inverse * inverse * inverse;
      x += dx * pull;
      y += dy * pull;
      z += dz * pull;
    }
    __syncthreads();
  }
  if (i < count) accelerations[i] = make_float4(x * gravity, y * gravity, z * gravity, 0);
}

}  // namespace

double cudaPairs(const float* bodies, float* accelerations, int count, float gravity, float softening,
                 int runs) {
  float4* in = nullptr;
  float4* out = nullptr;
  const std::size_t bytes = static_cast<std::size_t>(count) * sizeof(float4);
  if (cudaMalloc(&in, bytes) != cudaSuccess || cudaMalloc(&out, bytes) != cudaSuccess) return -1;
  cudaMemcpy(in, bodies, bytes, cudaMemcpyHostToDevice);
  cudaEvent_t begin, end;
  cudaEventCreate(&begin);
  cudaEventCreate(&end);
  double best = 1e300;
  for (int run = 0; run <= runs; ++run) {  // The first run is a warm-up.
    cudaEventRecord(begin);
    pairsKernel<<<(count - 1) / tileBodies + 1, tileBodies>>>(in, out, count, gravity, softening * softening);
    cudaEventRecord(end);
    cudaEventSynchronize(end);
    float milliseconds = 0;
    cudaEventElapsedTime(&milliseconds, begin, end);
    if (run > 0) best = std::min(best, milliseconds * 1e-3);
  }
  const bool good = cudaMemcpy(accelerations, out, bytes, cudaMemcpyDeviceToHost) == cudaSuccess;
  cudaFree(in);
  cudaFree(out);
  return good ? best : -1;
}

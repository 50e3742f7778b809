// Memory use and memory traffic of benchmarked simulations.
#pragma once
#include "gl/buffer.hpp"

#include <functional>

namespace simreel::bench {

/// Prints the results of `bench_fluid speed` and `bench_fluid water`: a square field with `side` cells per
/// side, alone on the device. `mostCycles` is the maximum number of cycles dispatched per projection; 0:
/// the default.
void printFluidSpeed(int side, int mostCycles);
void printWaterSpeed(int side);

/// Returns the name that the next buffer will get.
[[nodiscard]] GLuint nextBuffer();
/// Prints a line for every buffer created since `first`, the largest first, in bytes per cell for `cells`
/// cells.
void listBuffers(const char* what, GLuint first, double cells);

struct Taken {
  double wall = 1e30, processor = 1e30;  ///< wall-clock and processor time, s
};
/// Returns the minimum times over several runs of `work`; each run waits for the device.
[[nodiscard]] Taken leastOf(const std::function<void()>& work);

/// Prints the bytes per cell and step, and the ratio of the kernels' memory traffic per processor second to
/// the copy rate of one processor.
void printBytes(double bytes, double cellsPerProcessorSecond);

/// Returns the bytes that the device reads and writes per second of copying, the best of several runs.
[[nodiscard]] double copiedBySecond();

/// Measures steps of a field of `cells` cells in turns with copying on the same device, for a few seconds.
/// Prints rates of the median turn, bytes moved, and their fraction of the copy rate. `turn` runs `steps`
/// whole steps. `bytes` returns the bytes per cell and step; it is called after the turns.
void printSpeed(const char* name, double cells, int steps, const std::function<void()>& turn,
                const std::function<double()>& bytes);

}  // namespace simreel::bench

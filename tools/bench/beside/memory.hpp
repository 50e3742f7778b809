// Measures memory use and memory traffic of benchmarked simulations.
#pragma once
#include "gl/buffer.hpp"

#include <functional>

namespace simreel::bench {

/// These functions print the results of `bench_fluid speed` and `bench_fluid water`, for a square field
/// with `side` cells per side that runs alone on the device. `mostCycles`: maximum number of cycles
/// dispatched per projection; 0 for the default.
void printFluidSpeed(int side, int mostCycles);
void printWaterSpeed(int side);

/// Returns the OpenGL name that the next buffer will get.
[[nodiscard]] GLuint nextBuffer();
/// Prints a line for every buffer created since `first`, the largest first. Sizes are in bytes per cell for
/// `cells` cells.
void listBuffers(const char* what, GLuint first, double cells);

struct Taken {
  double wall = 1e30, processor = 1e30;  ///< minimum wall-clock and processor time in seconds
};
/// Returns the minimum times over several runs of `work`. Each run waits for the device.
[[nodiscard]] Taken leastOf(const std::function<void()>& work);

/// Prints the bytes per cell and step, and the ratio of the kernels' memory traffic per processor second to
/// the copy rate of one processor.
void printBytes(double bytes, double cellsPerProcessorSecond);

/// Returns the bytes per second that the device reads and writes while it copies, as the best of several
/// runs.
[[nodiscard]] double copiedBySecond();

/// Measures steps of a field of `cells` cells for a few seconds, alternating with copying on the same
/// device. Prints rates of the median turn, bytes moved, and their fraction of the copy rate. `turn` must
/// run `steps` whole steps. `bytes` returns the bytes per cell and step and is called after the turns.
void printSpeed(const char* name, double cells, int steps, const std::function<void()>& turn,
                const std::function<double()>& bytes);

}  // namespace simreel::bench

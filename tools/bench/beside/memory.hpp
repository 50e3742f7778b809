// Measures memory use and memory traffic of benchmarked simulations.
#pragma once
#include "gl/buffer.hpp"

#include <functional>

namespace simreel::bench {

/// These functions print the results of `bench_fluid speed` and `bench_fluid water`, for a square field
/// with `side` cells per side that runs alone on the device. `maxCycles`: maximum number of cycles
/// dispatched per projection; 0 for the default.
void printFluidSpeed(int side, int maxCycles);
void printWaterSpeed(int side);

/// Returns the OpenGL name that the next buffer will get.
[[nodiscard]] GLuint nextBuffer();
/// Prints a line for every buffer created since `first`, the largest first. Sizes are in bytes per cell for
/// `cells` cells.
void listBuffers(const char* what, GLuint first, double cells);

struct Taken {
  double wall = 1e30, processor = 1e30;  ///< minimum wall-clock and processor time in seconds
};
/// Runs `work` several times, waits for the device after each run, and returns the shortest times.
[[nodiscard]] Taken minimumOf(const std::function<void()>& work);

/// Prints the memory traffic of a step and compares it with copying on one processor. `bytes`: bytes per
/// cell and step. `cellsPerProcessorSecond`: cells that the kernels update per processor second.
void printBytes(double bytes, double cellsPerProcessorSecond);

/// Copies a buffer on the device several times. Returns the bytes read and written per second in the
/// fastest run.
[[nodiscard]] double copiedBySecond();

/// Measures steps of a field of `cells` cells for about five seconds, then the rate at which the device
/// copies memory. Prints the median rate, the bytes moved, and their rate as a fraction of the copy rate.
/// `turn` must run `steps` whole steps. `bytes` returns the bytes per cell and step and is called after all
/// turns.
void printSpeed(const char* name, double cells, int steps, const std::function<void()>& turn,
                const std::function<double()>& bytes);

}  // namespace simreel::bench

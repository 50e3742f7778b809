// What a benched simulation holds in memory and moves through it.
#pragma once
#include "gl/buffer.hpp"

#include <functional>

namespace simreel::bench {

/// What `bench_fluid speed` and `bench_fluid water` print: a square field of so many cells, alone on the
/// device. `mostCycles`: of a projection, so many are dispatched; 0: the standard.
void printFluidSpeed(int side, int mostCycles);
void printWaterSpeed(int side);

/// The name that the next buffer gets.
[[nodiscard]] GLuint nextBuffer();
/// A line for every buffer that was made since `first`, the greatest first, as bytes of one of `cells`.
void listBuffers(const char* what, GLuint first, double cells);

struct Taken {
  double wall = 1e30, processor = 1e30;  ///< s
};
/// The least of some turns, which wait for the device.
[[nodiscard]] Taken leastOf(const std::function<void()>& work);

/// Bytes that a cell moves in a step, and how much of what one processor copies a processor second of the
/// kernels moves.
void printBytes(double bytes, double cellsPerProcessorSecond);

/// Bytes that the device reads and writes in a second of copying, the best of some turns.
[[nodiscard]] double copiedBySecond();

/// Steps of a field of `cells`, in turns until they have taken a few seconds, beside copying on the same
/// device: rates of the median turn, bytes that move and what part of copying's that is. `turn`: so many
/// steps, each of them a whole one. `bytes` of a cell and step are asked for when the turns are over.
void printSpeed(const char* name, double cells, int steps, const std::function<void()>& turn,
                const std::function<double()>& bytes);

}  // namespace simreel::bench

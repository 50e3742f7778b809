// What a benched simulation holds in memory and moves through it.
#pragma once
#include "gl/buffer.hpp"

#include <functional>

namespace simreel::bench {

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

}  // namespace simreel::bench

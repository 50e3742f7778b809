#pragma once
#include "gl/buffer.hpp"
#include "gl/element_array.hpp"
#include "gl/program.hpp"

#include <span>
#include <string>

#include <glm/vec4.hpp>

namespace simreel::gl {

/// Sorts records of four words {lower key, upper key, value, value} on the device, without readback: least
/// significant digit first, four bits a pass of three dispatches. Stable, so the result is the same on
/// every driver. A pass reads a record twice and writes it once, 48 bytes.
class RadixSort {
 public:
  /// For up to `capacity` records. Throws UserError(device) beyond the device's limits, which the message
  /// names.
  RadixSort(const std::string& label, int capacity);

  /// Sorts records 0..count-1 by the lower `lowBits` (0, 4, .. 32) of their first word and the lower
  /// `highBits` of their second, which counts for more. Waits for writes before it; what follows sees the
  /// result.
  void sort(int count, int lowBits, int highBits);

  /// To be filled before sort(), in order after it. Bind it anew after a sort: the memory changes.
  [[nodiscard]] WordsArray& records() { return records_; }
  [[nodiscard]] const WordsArray& records() const { return records_; }

 private:
  void pass(int count, int word, int shift);

  int capacity_;
  bool texels_;
  int tile_;  ///< records of a tile
  WordsArray records_, next_;
  WordsArray digits_;  ///< four elements a tile: how many of its records have each digit; then the totals
  Program count_, scan_, scatter_;
};

}  // namespace simreel::gl

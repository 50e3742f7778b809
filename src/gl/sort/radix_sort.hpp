#pragma once
#include "gl/element_array.hpp"

#include <memory>
#include <string>

namespace simreel::gl {

/// Sorts records of four words {lower key, upper key, value, value} on the device without readback. Least
/// significant digit first, four bits per pass, three dispatches per pass. The sort is stable, so all
/// drivers give the same result. A pass reads each record twice and writes it once (48 bytes).
class RadixSort {
 public:
  /// Creates a sorter for up to `capacity` records. Throws UserError(device) that names the device's limit
  /// if it is exceeded.
  RadixSort(const std::string& label, int capacity);
  ~RadixSort();
  RadixSort(const RadixSort&) = delete;
  RadixSort& operator=(const RadixSort&) = delete;
  RadixSort(RadixSort&&) = delete;
  RadixSort& operator=(RadixSort&&) = delete;

  /// Sorts records 0..count-1. The key consists of the lower `highBits` bits of the second word and, less
  /// significant, the lower `lowBits` bits of the first word; both counts are multiples of 4 up to 32.
  /// Waits for earlier kernels, and later kernels wait for it; other readers need gl::barrier().
  void sort(int count, int lowBits, int highBits);

  /// Records: input of sort(), and its output. Must be bound again after each sort, because the buffers are
  /// swapped.
  [[nodiscard]] WordsArray& records() { return records_; }
  [[nodiscard]] const WordsArray& records() const { return records_; }

 private:
  struct Kernels;

  void pass(int count, int word, int shift);

  int capacity_;
  bool texels_;
  int tile_;  ///< number of records of a tile
  WordsArray records_, next_;
  WordsArray digits_;  ///< four elements per tile: the tile's record count for each digit; then the totals
  std::unique_ptr<Kernels> kernels_;
};

}  // namespace simreel::gl

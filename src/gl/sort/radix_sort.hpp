#pragma once
#include "gl/element_array.hpp"

#include <memory>
#include <string>

namespace simreel::gl {

/// Sorts records of four words {lower key, upper key, value, value} on the device without readback. Starts
/// with the least significant digit. Each pass sorts by one digit of four bits and takes three dispatches.
/// The sort is stable, so all drivers give the same result. A pass reads each record twice and writes it
/// once (48 bytes).
class RadixSort {
 public:
  /// Creates a sorter for up to `capacity` records. If a device limit is exceeded, throws UserError(device)
  /// that names the limit.
  RadixSort(const std::string& label, int capacity);
  ~RadixSort();
  RadixSort(const RadixSort&) = delete;
  RadixSort& operator=(const RadixSort&) = delete;
  RadixSort(RadixSort&&) = delete;
  RadixSort& operator=(RadixSort&&) = delete;

  /// Sorts the records 0 to count - 1. The more significant part of the key is the lower `highBits` bits of
  /// the second word. The less significant part is the lower `lowBits` bits of the first word. Both numbers
  /// are multiples of 4 up to 32. Waits for earlier kernels, and later kernels wait for the sort. Other
  /// readers need gl::barrier().
  void sort(int count, int lowBits, int highBits);

  /// Returns the records, which are the input and the output of sort(). They must be bound again after each
  /// sort, because the buffers are swapped.
  [[nodiscard]] WordsArray& records() { return records_; }
  [[nodiscard]] const WordsArray& records() const { return records_; }

 private:
  struct Kernels;

  void pass(int count, int word, int shift);

  int capacity_;
  bool texels_;
  int tile_;  ///< number of records per tile
  WordsArray records_, next_;
  WordsArray digits_;  ///< the tile's record count for each digit, four elements per tile; then the totals
                       ///< of all tiles
  std::unique_ptr<Kernels> kernels_;
};

}  // namespace simreel::gl

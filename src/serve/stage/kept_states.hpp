#pragma once
#include "frame/file/world_state.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace simreel::serve {

/// States of past frames, which make it fast to go back. Stores one state per interval of frames. Doubles
/// the interval when the states need more memory than allowed.
class KeptStates {
 public:
  explicit KeptStates(std::size_t byteLimit) : byteLimit_(byteLimit) {}

  /// True if the state of this frame should be stored.
  [[nodiscard]] bool wants(int frame) const {
    return frame >= 0 && frame % interval_ == 0 && !states_.contains(frame);
  }
  void keep(frame::WorldState state);
  /// Returns the latest stored state at or before a frame, or null. The pointer is valid until the states
  /// change.
  [[nodiscard]] const frame::WorldState* before(int frame) const;
  /// Removes the states of `frame` and of later frames.
  void forgetFrom(int frame);
  void clear();
  /// Changes the memory limit for kept states.
  void allow(std::size_t byteLimit);

  [[nodiscard]] std::vector<int> frames() const;
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] int interval() const { return interval_; }

 private:
  void thin();

  std::size_t byteLimit_;
  std::size_t bytes_ = 0;
  int interval_ = 1;
  std::map<int, frame::WorldState> states_;
};

}  // namespace simreel::serve

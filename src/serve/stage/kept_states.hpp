#pragma once
#include "frame/file/world_state.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace simreel::serve {

/// States of frames that were passed, so that going back is quick: every so many frames, twice as far apart
/// whenever they would need more memory than there is for them.
class KeptStates {
 public:
  explicit KeptStates(std::size_t mostBytes) : mostBytes_(mostBytes) {}

  /// Whether the state of this frame should be kept.
  [[nodiscard]] bool wants(int frame) const {
    return frame >= 0 && frame % interval_ == 0 && !states_.contains(frame);
  }
  void keep(frame::WorldState state);
  /// The latest at or before a frame; null: none. Lives until the next keep() or clear().
  [[nodiscard]] const frame::WorldState* before(int frame) const;
  /// Those of this frame and later ones.
  void forgetFrom(int frame);
  void clear();
  /// From now on.
  void allow(std::size_t mostBytes);

  [[nodiscard]] std::vector<int> frames() const;
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] int interval() const { return interval_; }

 private:
  void thin();

  std::size_t mostBytes_;
  std::size_t bytes_ = 0;
  int interval_ = 1;
  std::map<int, frame::WorldState> states_;
};

}  // namespace simreel::serve

#pragma once
#include <epoxy/gl.h>

namespace simreel::sim {

/// Limits the number of dispatches waiting on the GPU, so that a signal can end a long frame between two
/// dispatches.
class DispatchPace {
 public:
  DispatchPace() = default;
  ~DispatchPace();
  DispatchPace(const DispatchPace&) = delete;
  DispatchPace& operator=(const DispatchPace&) = delete;

  /// Call it after each dispatch. Throws the exceptions of checkFrame().
  void dispatched();

 private:
  static constexpr int atOnce = 16;
  int count_ = 0;
  GLsync before_ = nullptr;  ///< fence signalled when the last group of `atOnce` dispatches is complete
};

}  // namespace simreel::sim

#pragma once
#include <epoxy/gl.h>

namespace simreel::sim {

/// Keeps few dispatches waiting on the device, so that a signal ends a long frame between two of them.
class DispatchPace {
 public:
  DispatchPace() = default;
  ~DispatchPace();
  DispatchPace(const DispatchPace&) = delete;
  DispatchPace& operator=(const DispatchPace&) = delete;

  /// Call after each dispatch. Throws what checkFrame() throws.
  void dispatched();

 private:
  static constexpr int atOnce = 16;
  int count_ = 0;
  GLsync before_ = nullptr;  ///< signalled once the last group of `atOnce` dispatches is done
};

}  // namespace simreel::sim

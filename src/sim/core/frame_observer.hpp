#pragma once
#include <string>
#include <vector>

namespace simreel::sim {

/// What notes something of other objects in every frame, whether that is drawn or not.
class FrameObserver {
 public:
  virtual ~FrameObserver() = default;
  /// Names of the objects that it looks at.
  [[nodiscard]] virtual std::vector<std::string> observed() const = 0;
  /// Of the frame at `time` (s), once those objects are what is drawn of them.
  virtual void observe(double time) = 0;
};

}  // namespace simreel::sim

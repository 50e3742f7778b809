#pragma once

namespace simreel::sim {

/// Object that observes others in every frame, drawn or not. It observes the objects that it wants
/// When::afterFrame.
class FrameObserver {
 public:
  virtual ~FrameObserver() = default;
  /// Called once those objects are as the frame at `time` (s) shows them.
  virtual void observe(double time) = 0;
};

/// Object that reads the state of others at the start of a frame. It reads the objects that it wants
/// When::frameStart, and they may read it, too.
class FrameStarter {
 public:
  virtual ~FrameStarter() = default;
  /// Called before any object of a frame steps, and once when all are made.
  virtual void frameStarts() = 0;
};

}  // namespace simreel::sim

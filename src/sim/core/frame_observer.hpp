#pragma once

namespace simreel::sim {

/// Object that notes something of other objects in every frame, drawn or not: of those that it wants
/// When::afterFrame.
class FrameObserver {
 public:
  virtual ~FrameObserver() = default;
  /// Called once those objects are as the frame at `time` (s) shows them.
  virtual void observe(double time) = 0;
};

/// Object that takes in the state of others at the start of a frame: of those that it wants
/// When::frameStart, which may take in this one's, too.
class FrameStarter {
 public:
  virtual ~FrameStarter() = default;
  /// Called before any object of a frame steps, and once when all are made.
  virtual void frameStarts() = 0;
};

}  // namespace simreel::sim

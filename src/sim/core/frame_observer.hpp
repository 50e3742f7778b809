#pragma once

namespace simreel::sim {

/// Object that observes other objects after every frame, whether the frame is drawn or not. It declares the
/// observed objects with When::afterFrame.
class FrameObserver {
 public:
  virtual ~FrameObserver() = default;
  /// Called after each frame, when the observed objects have the state of the frame at `time` (seconds).
  virtual void observe(double time) = 0;
};

/// Object that reads the state of other objects at the start of a frame. It declares these objects with
/// When::frameStart; two such objects may read each other.
class FrameStarter {
 public:
  virtual ~FrameStarter() = default;
  /// Called before any object steps in a frame, and once after all objects are created.
  virtual void frameStarts() = 0;
};

}  // namespace simreel::sim

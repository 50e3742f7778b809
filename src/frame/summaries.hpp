#pragma once
#include "sim/world/world.hpp"

#include <functional>
#include <utility>

namespace simreel::frame {

/// Throws UserError(device) if a simulation lost its state at or before the current frame.
inline void checkState(sim::World& world) {
  world.startSummary();
  static_cast<void>(world.takeSummary(true));
}

/// Pipelines the state summaries of a world. Keeps as many summaries in flight as the world allows, so that
/// the device never waits. Passes each summary to `callback` in frame order. Throws UserError(device) if a
/// simulation lost its state.
class Summaries {
 public:
  using Callback = std::function<void(const sim::World::Summary& summary)>;
  Summaries(sim::World& world, Callback callback) : world_(world), callback_(std::move(callback)) {}

  /// Starts the summary of the current frame. If the max number of summaries is in flight, waits for the
  /// oldest first.
  void start() {
    if (underWay_ == sim::World::maxSummaries) takeOldest();
    world_.startSummary();
    ++underWay_;
  }
  void takeOldest() {
    SIMREEL_CHECK(underWay_ > 0);
    --underWay_;  // Decrements first, because the world drops the summary of a lost state, too.
    const auto summary = world_.takeSummary(true);
    callback_(*summary);
  }
  void takeAll() {
    while (underWay_ > 0) takeOldest();
  }

 private:
  sim::World& world_;
  Callback callback_;
  int underWay_ = 0;
};

}  // namespace simreel::frame

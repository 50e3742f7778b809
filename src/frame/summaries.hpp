#pragma once
#include "sim/world/world.hpp"

#include <functional>
#include <utility>

namespace simreel::frame {

/// Throws UserError(device) when a simulation lost its state up to the present frame.
inline void checkState(sim::World& world) {
  world.startSummary();
  static_cast<void>(world.takeSummary(true));
}

/// Summaries of a world's frames, as many under way as it allows, so that the device steps on meanwhile.
/// Each goes to `take` in the order of frames. Throws UserError(device) when a simulation lost its state.
class Summaries {
 public:
  using Take = std::function<void(const sim::World::Summary& summary)>;
  Summaries(sim::World& world, Take take) : world_(world), take_(std::move(take)) {}

  /// Of the present frame; waits for the oldest where there is no room for another.
  void start() {
    if (underWay_ == sim::World::maxSummaries) takeOldest();
    world_.startSummary();
    ++underWay_;
  }
  void takeOldest() {
    SIMREEL_CHECK(underWay_ > 0);
    const auto summary = world_.takeSummary(true);
    --underWay_;
    take_(*summary);
  }
  void takeAll() {
    while (underWay_ > 0) takeOldest();
  }

 private:
  sim::World& world_;
  Take take_;
  int underWay_ = 0;
};

}  // namespace simreel::frame

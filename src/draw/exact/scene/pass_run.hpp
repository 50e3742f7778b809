#pragma once
#include "draw/exact/scene/exact_frame.hpp"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace simreel::draw {

/// Runs the passes of `exactPasses`, each as often as its entry says.
class PassRun {
 public:
  /// The frame must outlive it.
  explicit PassRun(ExactFrame& frame);
  /// The picture that ExactFrame::asked has.
  void draw(const ExactScene::Watch& watch);
  void asked();

 private:
  using Range = std::pair<std::size_t, std::size_t>;  ///< the first entry, and one after the last

  [[nodiscard]] std::size_t endOf(std::size_t first, Each each) const;
  [[nodiscard]] std::vector<std::size_t> lostBefore(Range group, std::size_t firstOfView) const;
  void runOnce(Range group);
  void runView(Range group);
  void runBands(Range group, std::size_t firstOfView);
  void run(std::size_t pass, bool again = false);
  void endStage();

  ExactFrame& frame_;
  std::vector<std::unique_ptr<Pass>> passes_;
  const ExactScene::Watch* watch_ = nullptr;
  const char* stage_ = nullptr;  ///< under way; null: none
};

}  // namespace simreel::draw

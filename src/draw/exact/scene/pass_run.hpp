#pragma once
#include "draw/exact/scene/exact_frame.hpp"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace simreel::draw {

/// Runs the passes in `exactPasses`, each with the frequency of its entry.
class PassRun {
 public:
  /// `frame` must outlive this object.
  explicit PassRun(ExactFrame& frame);
  /// Draws the picture that ExactFrame::asked describes.
  void draw(const ExactScene::StageCallback& watch);
  void asked();

 private:
  using Range = std::pair<std::size_t, std::size_t>;  ///< range of pass indices, first (inclusive) to last
                                                      ///< (exclusive)

  [[nodiscard]] std::size_t endOf(std::size_t first, Each each) const;
  [[nodiscard]] std::vector<std::size_t> lostBefore(Range group, std::size_t firstOfView) const;
  void runOnce(Range group);
  void runView(Range group);
  void runBands(Range group, std::size_t firstOfView);
  void run(std::size_t pass, bool again = false);
  void endStage();

  ExactFrame& frame_;
  std::vector<std::unique_ptr<Pass>> passes_;
  const ExactScene::StageCallback* watch_ = nullptr;
  const char* stage_ = nullptr;  ///< name of the current stage; null between stages
};

}  // namespace simreel::draw

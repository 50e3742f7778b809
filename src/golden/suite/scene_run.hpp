#pragma once
#include "frame/image.hpp"
#include "golden/baseline/baseline.hpp"
#include "golden/result.hpp"
#include "scene/scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// One tested frame as this program made it.
struct RunFrame {
  int frame = 0;
  double time = 0;  ///< s
  frame::Image image;
  std::string pixels;  ///< pixelHash
  StateHashes state;
};

struct SceneRun {
  std::vector<RunFrame> frames;
  std::vector<CheckResult> checks;
  double simulateSeconds = 0;  ///< of the clock, the device's work included
};

/// Simulates and draws the frames on the current context, evaluating the scene's checks on the way. Throws
/// UserError as World, Renderer and Checker do, and Interrupted after SIGINT or SIGTERM.
[[nodiscard]] SceneRun runScene(const scene::Scene& scene, std::span<const int> frames);

/// "frame 60: flag.positions differs", or "frame 60: the pictures differ": the first difference between two
/// runs of one scene, or empty.
[[nodiscard]] std::string runDifference(const SceneRun& first, const SceneRun& second);

}  // namespace simreel::golden

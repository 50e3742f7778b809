#pragma once
#include "frame/image.hpp"
#include "golden/baseline/baseline.hpp"
#include "golden/result.hpp"
#include "scene/scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// One tested frame, as rendered by this program.
struct RunFrame {
  int frame = 0;
  double time = 0;  ///< time of the frame in seconds
  frame::Image image;
  std::string pixels;  ///< pixelHash of `image`
  StateHashes state;
};

struct SceneRun {
  std::vector<RunFrame> frames;
  std::vector<CheckResult> checks;
  double simulateSeconds = 0;  ///< wall-clock time (s), including the device's work
};

/// Simulates and draws the given frames on the current context, and evaluates the scene's checks. Throws
/// the UserErrors of World, Renderer and Checker, and Interrupted after SIGINT or SIGTERM.
[[nodiscard]] SceneRun runScene(const scene::Scene& scene, std::span<const int> frames);

/// Returns the first difference between two runs of one scene: "frame 60: the state of flag.positions
/// differs" or "frame 60: the pictures differ". Returns an empty text if the runs are equal.
[[nodiscard]] std::string runDifference(const SceneRun& first, const SceneRun& second);

}  // namespace simreel::golden

#pragma once
#include <string>
#include <vector>

namespace simreel::golden {

/// Options for promoting a report's results to baselines.
struct Acceptance {
  std::vector<std::string> only;  ///< globs on the names of scenes to accept; empty: all scenes
  std::string reason;
  bool alternate = false;  ///< true to add an alternate instead of replacing the baseline
  std::string expected;    ///< folder of the picture baselines; empty: the report's folder
  std::string scenes;      ///< folder that must contain the scenes; empty: the current folder
};

struct Accepted {
  std::string scene;
  std::string problem;   ///< reason why the result was not promoted; empty if it was
  bool already = false;  ///< true if the baseline already has these pixels and this state
};

}  // namespace simreel::golden

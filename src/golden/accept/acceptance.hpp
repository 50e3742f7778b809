#pragma once
#include <string>
#include <vector>

namespace simreel::golden {

/// Options for promoting a report's results to baselines.
struct Acceptance {
  std::vector<std::string> only;  ///< globs for the names of the scenes to accept; if empty, all scenes are
                                  ///< accepted
  std::string reason;
  bool alternate = false;  ///< true to add an alternate instead of replacing the baseline
  std::string expected;    ///< folder of the picture baselines; if empty, the report's folder is used
  std::string scenes;      ///< folder that must contain the scenes; if empty, the current folder is used
};

struct Accepted {
  std::string scene;
  std::string problem;   ///< reason why the result was not promoted; empty if it was promoted
  bool already = false;  ///< true if the baseline already has these pixels and this state
};

}  // namespace simreel::golden

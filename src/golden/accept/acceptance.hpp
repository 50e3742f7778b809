#pragma once
#include <string>
#include <vector>

namespace simreel::golden {

/// What of a report becomes baselines.
struct Acceptance {
  std::vector<std::string> only;  ///< globs on scene names; empty: all
  std::string reason;
  bool alternate = false;  ///< as an alternate beside the baseline
  std::string expected;    ///< of pictures: the folder of the baselines; empty: as the report says
  std::string scenes;      ///< the folder that scenes have to lie below; empty: the current one
};

struct Accepted {
  std::string scene;
  std::string problem;   ///< why it was not promoted; empty: it was
  bool already = false;  ///< the baseline has these pixels and this state
};

}  // namespace simreel::golden

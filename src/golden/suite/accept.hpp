#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

struct Acceptance {
  std::vector<std::string> only;  ///< globs on scene names; empty: all
  std::string reason;
  bool alternate = false;  ///< as an alternate beside the baseline
  std::string expected;    ///< of pictures: the folder of the baselines; empty: as the report says
};

struct Accepted {
  std::string scene;
  std::string problem;   ///< why it was not promoted; empty: it was
  bool already = false;  ///< the baseline has these pixels and this state
};

/// Promotes what a report's run made to baselines, without rendering: the pictures whose pixels the report
/// lists, and the state. Scenes that passed are left out. A scene whose baseline has changed since that
/// run, or whose kept pictures have not the pixels they had, is not promoted. Throws UserError(usage) for a
/// report that cannot be used, also where that is of pictures and names a folder outside of this one.
[[nodiscard]] std::vector<Accepted> acceptReport(const std::filesystem::path& report,
                                                 const Acceptance& how);

}  // namespace simreel::golden

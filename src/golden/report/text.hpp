#pragma once
#include "golden/result.hpp"

#include <filesystem>
#include <string>

namespace simreel::golden {

/// Returns the lines for one scene for a terminal, with ANSI colours if `color` is true. A message that
/// occurs several times in a scene (in frames, checks or the divergence) is shown once. `reportFolder` is
/// prepended to image paths if it is not empty. `unit` is as in SuiteResult. For the unit "picture", no
/// number of frames is shown.
[[nodiscard]] std::string sceneLine(const SceneResult& scene, bool color = false,
                                    const std::filesystem::path& reportFolder = {},
                                    const std::string& unit = "scene");
/// Returns the end of the terminal output. It contains stale baselines, notes of the run, a line such as "3
/// scenes: 2 passed, 1 failed (flag) in 6.2 s", the command that accepts the run, and the path of the
/// report.
[[nodiscard]] std::string closingText(const SuiteResult& suite, bool color = false,
                                      const std::filesystem::path& report = {});

}  // namespace simreel::golden

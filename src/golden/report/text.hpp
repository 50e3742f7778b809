#pragma once
#include "golden/result.hpp"

#include <filesystem>
#include <string>

namespace simreel::golden {

/// For people at a terminal; lines that end in newlines, with ANSI colours if asked. Messages that a scene
/// repeats (of a frame, a check, the divergence) are shown once.
/// `reportFolder` is put before the paths of images; empty: they are shown as they are. A picture (`unit`,
/// as in SuiteResult) has no frames to count.
[[nodiscard]] std::string sceneLine(const SceneResult& scene, bool color = false,
                                    const std::filesystem::path& reportFolder = {},
                                    const std::string& unit = "scene");
/// What is stale, notes of the run, "3 scenes: 2 passed, 1 failed (flag) in 6.2 s", the command that
/// accepts the run, and where the report is.
[[nodiscard]] std::string closingText(const SuiteResult& suite, bool color = false,
                                      const std::filesystem::path& report = {});

}  // namespace simreel::golden

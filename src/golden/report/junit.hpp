#pragma once
#include "golden/result.hpp"

#include <filesystem>
#include <string>

namespace simreel::golden {

/// Returns JUnit XML: one suite with one case per scene, times in seconds. Replaces characters that XML 1.0
/// forbids by U+FFFD. `pictures`: path of the report's folder relative to the base folder of GitLab or
/// Jenkins; it is prepended to picture paths. Attaches the pictures of failing scenes
/// ("[[ATTACHMENT|path]]"), the worst frame's pictures first, because GitLab shows only one. If `pictures`
/// is empty, attaches none.
[[nodiscard]] std::string junitText(const SuiteResult& suite, const std::filesystem::path& pictures = {});

}  // namespace simreel::golden

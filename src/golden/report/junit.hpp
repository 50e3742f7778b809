#pragma once
#include "golden/result.hpp"

#include <filesystem>
#include <string>

namespace simreel::golden {

/// Returns JUnit XML with one suite and one case per scene. Times are in seconds. Replaces characters that
/// XML 1.0 forbids by U+FFFD. `pictures`: path of the report's folder relative to the base folder of GitLab
/// or Jenkins. It is prepended to picture paths. Attaches the pictures of failing scenes
/// ("[[ATTACHMENT|path]]"). The pictures of the worst frame come first, because GitLab shows only one
/// picture. If `pictures` is empty, attaches no pictures.
[[nodiscard]] std::string junitText(const SuiteResult& suite, const std::filesystem::path& pictures = {});

}  // namespace simreel::golden

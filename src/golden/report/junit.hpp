#pragma once
#include "golden/result.hpp"

#include <filesystem>
#include <string>

namespace simreel::golden {

/// JUnit XML: one suite, a case for each scene; times in s. Characters that XML 1.0 forbids become U+FFFD.
/// `pictures` is what GitLab and Jenkins put before the paths of pictures: the report's folder, relative to
/// theirs. Those of a scene that fails are attached ("[[ATTACHMENT|path]]"), the worst frame's first,
/// because GitLab shows one; empty: none are.
[[nodiscard]] std::string junitText(const SuiteResult& suite, const std::filesystem::path& pictures = {});

}  // namespace simreel::golden

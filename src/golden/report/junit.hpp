#pragma once
#include "golden/result.hpp"

#include <string>

namespace simreel::golden {

/// JUnit XML: one suite, a case for each scene; times in s. Characters that XML 1.0 forbids become U+FFFD.
[[nodiscard]] std::string junitText(const SuiteResult& suite);

}  // namespace simreel::golden

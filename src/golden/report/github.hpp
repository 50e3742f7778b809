#pragma once
#include "golden/result.hpp"

#include <string>

namespace simreel::golden {

/// Workflow commands for GitHub's log ("::error file=...,title=...::..."), a line each: an error for every
/// scene that fails the run, a warning for a flaky one that does not and for every note that speaks of a
/// loose tolerance (holds "loose"), a notice for updated baselines.
[[nodiscard]] std::string githubAnnotations(const SuiteResult& suite);
/// Markdown for GitHub's job summary, below 1 MB (GitHub drops one above 1 MiB): where scenes had to be
/// left out it says how many.
[[nodiscard]] std::string githubSummary(const SuiteResult& suite);

}  // namespace simreel::golden

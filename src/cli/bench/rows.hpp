#pragma once
#include "scene/scene.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::cli {

/// One row of a benchmark: a scene with some values changed.
struct BenchCase {
  std::string name;                      ///< name of the case: "jobs", or "substeps=4, samples=1"
  std::vector<scene::Override> changes;  ///< overrides of the case, applied after -D
};

/// One value of --vary or --technique, and the overrides that set it.
struct BenchChoice {
  std::string name;
  std::vector<scene::Override> changes;
};

/// Parses "path=a,b,c" into one choice per value. Commas inside brackets, braces and quotes are part of a
/// value. Throws UserError(usage).
[[nodiscard]] std::vector<BenchChoice> parseVary(const std::string& text);

/// Parses "all" or words separated by commas into one choice per technique. A choice sets "technique" in
/// every object whose kind supports that technique. Throws UserError(usage) if no object supports it.
[[nodiscard]] std::vector<BenchChoice> parseTechniques(const std::string& text, const scene::Scene& scene,
                                                       std::span<const scene::Kind> kinds);

/// Returns every combination of one choice from each list. The last list varies fastest. If `lists` is
/// empty, returns one case with the name `plain`. Throws UserError(usage) for more than 64 cases.
[[nodiscard]] std::vector<BenchCase> combine(std::span<const std::vector<BenchChoice>> lists,
                                             const std::string& plain);

}  // namespace simreel::cli

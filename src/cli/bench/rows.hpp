#pragma once
#include "scene/scene.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::cli {

/// One line of a benchmark: a scene with some values changed.
struct BenchCase {
  std::string name;                      ///< "jobs"; "substeps=4, samples=1"
  std::vector<scene::Override> changes;  ///< on top of -D
};

/// One value of a --vary or --technique, and what sets it.
struct BenchChoice {
  std::string name;
  std::vector<scene::Override> changes;
};

/// "path=a,b,c": one choice for each value. Commas within brackets, braces and quotes belong to a value.
/// Throws UserError(usage).
[[nodiscard]] std::vector<BenchChoice> parseVary(const std::string& text);

/// "all", or words with commas: one choice for each, set in every object whose kind has a choice
/// "technique" that knows the word. Throws UserError(usage) where no object does.
[[nodiscard]] std::vector<BenchChoice> parseTechniques(const std::string& text, const scene::Scene& scene,
                                                       std::span<const scene::Kind> kinds);

/// Every combination, the last list running fastest; one case named `plain` for no lists. Throws
/// UserError(usage) beyond 64.
[[nodiscard]] std::vector<BenchCase> combine(std::span<const std::vector<BenchChoice>> lists,
                                             const std::string& plain);

}  // namespace simreel::cli

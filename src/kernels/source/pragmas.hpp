#pragma once
#include "kernels/source/files.hpp"

#include <string>
#include <utility>
#include <vector>

namespace simreel::kernels {

enum class Language { hlsl, glsl };

/// A kernel announced by its file.
struct Announced {
  std::string name;
  std::vector<std::pair<std::string, std::string>> defines;
  int line = 0;
};

/// The contents of "#pragma kernel" and "#pragma multi_compile" lines, and the functions with thread
/// groups.
struct Announcements {
  Language language = Language::hlsl;
  std::vector<Announced> kernels;
  std::vector<std::vector<std::string>>
      keywords;  ///< exactly one keyword of each list is active; "_" stands for none

  /// Returns the active keywords: from each list the chosen one, else the first. Chosen keywords that no
  /// list contains are added to `unknown`.
  [[nodiscard]] std::vector<std::string> held(const std::vector<std::string>& chosen,
                                              std::vector<std::string>& unknown) const;
};

[[nodiscard]] Announcements announcements(const Files& files);

/// Renames a kernel in `text` and returns its new name, if other functions have the same name or if
/// `always`. Reason: glslang takes every function with the entry point's name for the entry point.
[[nodiscard]] std::string entryName(std::string& text, const std::string& kernel, bool always);

}  // namespace simreel::kernels

#pragma once
#include "kernels/source/files.hpp"

#include <string>
#include <utility>
#include <vector>

namespace simreel::kernels {

enum class Language { hlsl, glsl };

/// A kernel that a file declares, with "#pragma kernel" or in another way.
struct Announced {
  std::string name;
  std::vector<std::pair<std::string, std::string>> defines;
  int line = 0;
};

/// Contents of the "#pragma kernel" and "#pragma multi_compile" lines, and the functions with [numthreads].
struct Announcements {
  Language language = Language::hlsl;
  std::vector<Announced> kernels;
  std::vector<std::vector<std::string>>
      keywords;  ///< lists of keywords, of which exactly one per list is active; "_" stands for no keyword

  /// Returns the active keywords. Each list contributes the chosen keyword, or its first one if none was
  /// chosen. Chosen keywords that are in no list are added to `unknown`.
  [[nodiscard]] std::vector<std::string> held(const std::vector<std::string>& chosen,
                                              std::vector<std::string>& unknown) const;
};

[[nodiscard]] Announcements announcements(const Files& files);

/// Renames a kernel in `text` if other functions have the same name or if `always` is true. Returns the new
/// name. Renaming is needed because glslang treats every function with the entry point's name as the entry
/// point.
[[nodiscard]] std::string entryName(std::string& text, const std::string& kernel, bool always);

}  // namespace simreel::kernels

#pragma once
#include "kernels/source/files.hpp"

#include <string>
#include <utility>
#include <vector>

namespace simreel::kernels {

enum class Language { hlsl, glsl };

/// A kernel as its file announces it.
struct Announced {
  std::string name;
  std::vector<std::pair<std::string, std::string>> defines;
  int line = 0;
};

/// What the lines "#pragma kernel", "#pragma multi_compile" and the functions with thread groups say.
struct Announcements {
  Language language = Language::hlsl;
  std::vector<Announced> kernels;
  std::vector<std::vector<std::string>> keywords;  ///< one of each list holds; "_" is none

  /// The keywords that hold: of each list the chosen one, else the first. A choice that no list has goes to
  /// `unknown`.
  [[nodiscard]] std::vector<std::string> held(const std::vector<std::string>& chosen,
                                              std::vector<std::string>& unknown) const;
};

[[nodiscard]] Announcements announcements(const Files& files);

/// glslang takes every function of an entry point's name for one: where the kernel shares its name with
/// others, or `always`, `text` calls it another name, which is given back.
[[nodiscard]] std::string entryName(std::string& text, const std::string& kernel, bool always);

}  // namespace simreel::kernels

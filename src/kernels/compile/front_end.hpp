#pragma once
#include "kernels/source/files.hpp"
#include "kernels/source/pragmas.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace simreel::kernels {

/// One kernel to compile.
struct Unit {
  Language language = Language::hlsl;
  std::string entry = "main";
  std::vector<std::pair<std::string, std::string>> defines;
  int line = 1;             ///< where the file announces it
  std::string before = {};  ///< text in front of the file, which counts no lines
  std::string behind = {};  ///< and after it
};

/// SPIR-V 1.3 as the front end makes it, unoptimized, with the lines of the first file and of what it
/// includes (texts of lines are numbers of Files). This is all that the program knows of glslang. Throws a
/// UserError that reports the mistakes at their places. Files that are included are added to `files`.
[[nodiscard]] std::vector<std::uint32_t> compile(Files& files, const Unit& unit);

/// The same of GLSL of our own, whose functions are kept although nothing calls them. Throws
/// std::runtime_error.
[[nodiscard]] std::vector<std::uint32_t> compileLibrary(const std::string& text);

}  // namespace simreel::kernels

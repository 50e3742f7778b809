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
  int line = 1;             ///< line of the file that declares the kernel
  std::string before = {};  ///< text inserted before the file; it does not affect line numbers
  std::string behind = {};  ///< text appended after the file
};

/// Compiles a kernel with glslang to unoptimized SPIR-V 1.3. The SPIR-V has line information for the first
/// file and its includes: OpLine refers to indices in Files. No other part of the program uses glslang.
/// Throws a UserError that lists the errors with file and line. Adds included files to `files`.
[[nodiscard]] std::vector<std::uint32_t> compile(Files& files, const Unit& unit);

/// Compiles the program's own GLSL library and keeps functions without callers in the result. Throws
/// std::runtime_error.
[[nodiscard]] std::vector<std::uint32_t> compileLibrary(const std::string& text);

}  // namespace simreel::kernels

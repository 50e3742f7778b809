#pragma once
#include "kernels/source/files.hpp"
#include "kernels/spirv/module.hpp"

#include <cstddef>

namespace simreel::kernels {

/// A file of Files and a line in it; line 0 for code that has none, such as the library's.
struct Position {
  std::size_t file = 0;
  int line = 0;
  /// Goes on to the next instruction of a body.
  void follow(const Module& module, const Files& files, const Instruction& one);
};

/// Repeats the line of code at the start of each block: SPIRV-Tools takes a line to end with its block.
void repeatLines(Module& module);

/// The variable, array or member that the last of some indices of a chain of pointers selects from, as the
/// user named it.
[[nodiscard]] std::string indexedName(const Module& module, Id variable, std::span<const Id> indices);

}  // namespace simreel::kernels

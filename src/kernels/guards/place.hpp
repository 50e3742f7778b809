#pragma once
#include "kernels/source/files.hpp"
#include "kernels/spirv/module.hpp"

#include <cstddef>

namespace simreel::kernels {

/// Source position: index of a file in Files, and a line. The line is 0 for code without a source line,
/// such as the library's.
struct Position {
  std::size_t file = 0;
  int line = 0;
  /// Updates the position from one instruction. Must be called for all instructions of a body in order.
  void follow(const Module& module, const Files& files, const Instruction& one);
};

/// Repeats the current source line at the start of each block, because SPIRV-Tools ends a line's range at
/// the end of its block.
void repeatLines(Module& module);

/// Returns the name in the source of the variable, array or member that the last index of an access chain
/// selects from.
[[nodiscard]] std::string indexedName(const Module& module, Id variable, std::span<const Id> indices);

}  // namespace simreel::kernels

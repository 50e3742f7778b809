#pragma once
#include "gl/kernel/kernel.hpp"
#include "sim/core/drawable.hpp"

namespace simreel::sim {

/// Part of a kernel interface: members of glsl/grid/field.glsl.
struct FieldPart {
  gl::Uniform<"fieldSize", glm::ivec2> size;
  gl::Uniform<"rowWords", int> rowWords;
  gl::Uniform<"firstWord", int> firstWord;
  gl::Uniform<"cellWords", int> cellWords;
  gl::In<"fieldWords"> words;
};
/// Defines CELLS of glsl/grid/field.glsl, with the values of Field::Cells.
using FieldCells = gl::Choice<"CELLS", 0, 1, 2, 3>;

[[nodiscard]] inline FieldPart partOf(const Field& field) {
  return {.size = field.size,
          .rowWords = field.rowWords,
          .firstWord = field.firstWord,
          .cellWords = field.cellWords,
          .words = *field.words};
}

}  // namespace simreel::sim

#pragma once
#include "gl/buffer.hpp"
#include "gl/element_array.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "sim/automata/engine/grid_shape.hpp"
#include "sim/automata/rule/cell_rule.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Advances a grid of cells by any rule with any border (glsl/automata): first the cells as bytes with a
/// margin that the border fills, then the rule, which so meets no edge. For what LifeStepper cannot do.
class CellEngine {
 public:
  /// `bits`: cells of two states come and go as bits (rows of 128 cells), else as bytes (rows of 16).
  /// Throws UserError(device) where the memory for it is beyond the device's limits; `object` is what the
  /// message calls it.
  CellEngine(const CellRule& rule, const GridShape& shape, glm::ivec2 size, bool bits,
             const std::string& object);

  /// One generation. Earlier writes must be visible (gl::barrier).
  void run(const gl::WordsArray& from, const gl::WordsArray& to);

  /// Bytes of the padded cells, and of the sums of columns where there are any.
  [[nodiscard]] std::size_t bytes() const {
    return padded_.buffer().bytes() + sums_.buffer().bytes() + rowSums_.buffer().bytes();
  }

 private:
  void makeNine(const CellRule& rule);
  void makeCyclic(const CellRule& rule);
  void makeWide(const CellRule& rule);
  void makeRunning(const WideRule& rule, gl::Defines all);
  void makeFar(const WideRule& rule, gl::Defines all);
  void makePlaces(const WideRule& rule, gl::Defines all);
  /// The last pass, which writes the next cells.
  void makeRule(const char* kernel, const gl::Defines& defines);
  /// The pass before it, which adds up 2 range + 1 rows.
  void makeColumns(const char* kernel);
  /// What the last pass reads besides cells.
  void makeList(const char* name, const std::vector<std::uint32_t>& list);
  [[nodiscard]] gl::Defines defines() const;

  glm::ivec2 size_;
  bool bits_;
  int range_, marginX_, rowItems_, paddedItems_, items_ = 1;
  int states_;
  int lanes_ = 1;        ///< invocations that write an element
  bool turned_ = false;  ///< whether the last pass counts rows first
  gl::WordsArray padded_, rowSums_, sums_;
  gl::Texture paddedWords_, paddedBytes_, sumWords_, treeItems_;
  gl::Buffer tree_;
  gl::Program pad_, rowSum_, columns_, rule_;
};

}  // namespace simreel::sim

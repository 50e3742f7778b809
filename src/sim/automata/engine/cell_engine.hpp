#pragma once
#include "gl/buffer.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/automata/engine/grid_shape.hpp"
#include "sim/automata/rule/cell_rule.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

struct PadKernel;
struct RowSumsKernel;
struct ColumnsKernel;
struct WindowSumsKernel;
struct CellRulePart;
struct WideDefines;

/// Advances a grid of cells by any rule with any border (glsl/automata): first the cells as bytes with a
/// margin that the border fills, then the rule, which so meets no edge. For what LifeStepper cannot do.
class CellEngine {
 public:
  /// `bits`: cells of two states come and go as bits (rows of 128 cells), else as bytes (rows of 16).
  /// Throws UserError(device) where the memory for it is beyond the device's limits; `object` is what the
  /// message calls it.
  CellEngine(const CellRule& rule, const GridShape& shape, glm::ivec2 size, bool bits,
             const std::string& object);

  ~CellEngine() = default;
  CellEngine(const CellEngine&) = delete;
  CellEngine& operator=(const CellEngine&) = delete;
  CellEngine(CellEngine&&) = delete;
  CellEngine& operator=(CellEngine&&) = delete;

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
  void makeRunning(const WideRule& rule, const WideDefines& wide);
  void makeFar(const WideRule& rule, const WideDefines& wide);
  void makePlaces(const WideRule& rule, const WideDefines& wide);
  /// Makes the last pass, which writes the next cells, of a kernel and of what its dispatch is given.
  template <class Kernel, class Given>
  void makeRule(const typename Kernel::Variant& variant, const Given& given);
  /// What the last pass reads besides cells.
  void makeList(const char* name, const std::vector<std::uint32_t>& list);

  glm::ivec2 size_;
  bool bits_;
  int range_, marginX_, rowItems_, paddedItems_, items_ = 1;
  int states_;
  int lanes_ = 1;        ///< invocations that write an element
  bool turned_ = false;  ///< whether the last pass counts rows first
  gl::WordsArray padded_, rowSums_, sums_;
  gl::Texture paddedWords_, paddedBytes_, sumWords_, treeItems_;
  gl::Buffer tree_;
  gl::Kernel<PadKernel> pad_;
  gl::Kernel<RowSumsKernel> rowSum_;
  gl::Kernel<ColumnsKernel> columns_;       ///< adds up 2 range + 1 rows
  gl::Kernel<WindowSumsKernel> windowSum_;  ///< the same of sums of rows
  std::function<void(const CellRulePart&, glm::ivec2 items)> rule_;
  shader::GridJoin join_;
};

}  // namespace simreel::sim

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

/// Advances a grid of cells by any rule with any border (glsl/automata). First copies the cells to bytes
/// with a margin that is filled according to the border, then applies the rule without any handling of
/// borders. Used for all rules that LifeStepper does not support.
class CellEngine {
 public:
  /// If `bits` is true, the cells have two states and are passed as bits (rows padded to 128 cells),
  /// otherwise as bytes (rows padded to 16 cells). Throws UserError(device) if the memory exceeds the
  /// device's limits. `object` is the name for the message.
  CellEngine(const CellRule& rule, const GridShape& shape, glm::ivec2 size, bool bits,
             const std::string& object);

  ~CellEngine() = default;
  CellEngine(const CellEngine&) = delete;
  CellEngine& operator=(const CellEngine&) = delete;
  CellEngine(CellEngine&&) = delete;
  CellEngine& operator=(CellEngine&&) = delete;

  /// Computes one generation.
  void run(const gl::WordsArray& from, const gl::WordsArray& to);

  /// Returns the size in bytes of the padded cells and, if there are any, of the sums.
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
  /// Creates the last pass, which writes the next cells. `given` converts the common interface part to the
  /// kernel's complete interface.
  template <class Kernel, class Given>
  void makeRule(const typename Kernel::Variant& variant, const Given& given);
  /// Uploads a list that the last pass reads in addition to the cells.
  void makeList(const char* name, const std::vector<std::uint32_t>& list);

  glm::ivec2 size_;
  bool bits_;
  int range_, marginX_, rowItems_, paddedItems_, items_ = 1;
  int states_;
  int lanes_ = 1;        ///< Number of invocations that write one element.
  bool turned_ = false;  ///< True if the last pass dispatches rows along x.
  gl::WordsArray padded_, rowSums_, sums_;
  gl::Texture paddedWords_, paddedBytes_, sumWords_, treeItems_;
  gl::Buffer tree_;
  gl::Kernel<PadKernel> pad_;
  gl::Kernel<RowSumsKernel> rowSum_;
  gl::Kernel<ColumnsKernel> columns_;       ///< Kernel that sums 2 range + 1 rows of cells.
  gl::Kernel<WindowSumsKernel> windowSum_;  ///< Kernel that sums 2 range + 1 rows of prefix sums.
  std::function<void(const CellRulePart&, glm::ivec2 items)> rule_;
  shader::GridJoin join_;
};

}  // namespace simreel::sim

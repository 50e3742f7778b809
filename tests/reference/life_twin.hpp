#pragma once
#include "sim/life/plan.hpp"
#include "sim/life/rle.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

/// A byte a cell and a plain loop over neighbours: what a generation is, written so that it can be checked
/// by reading. Rows without gaps.
std::vector<std::uint8_t> nextBytes(const std::vector<std::uint8_t>& cells, glm::ivec2 size,
                                    const simreel::sim::LifeRule& rule, bool torus);
/// The same for B3/S23 on a torus, as one writes it for speed with a byte a cell: rows with a ghost cell at
/// each end, whole rows in one loop that compilers turn into vector code. `cells` has size.x + 2 bytes a
/// row and size.y + 2 rows; ghosts are filled in here.
void fastBytes(std::vector<std::uint8_t>& cells, std::vector<std::uint8_t>& next, glm::ivec2 size);

/// Bits of blocked rows (sim::CellRows) as bytes without gaps, and back.
std::vector<std::uint8_t> bytesOf(const std::vector<std::uint32_t>& words, glm::ivec2 size);
std::vector<std::uint32_t> wordsOf(const std::vector<std::uint8_t>& cells, glm::ivec2 size);

/// Automata on the CPU: the kernels' own logic (glsl/life/model.glsl compiled as C++) on 64 cells at once.
/// Equals the GPU bit for bit.
class LifeTwin {
 public:
  /// `start`: time (s) of the first state.
  explicit LifeTwin(simreel::sim::LifePlan plan, double start = 0);

  /// One frame starting at `time` (s). `threads` 0: all processors.
  void step(double time, int threads = 1);
  /// One generation of the rule, without strokes and trail.
  void generation(int threads = 1);

  std::vector<std::uint32_t> words;  ///< as the GPU has them
  std::vector<std::uint32_t> trail;  ///< four cells a word; empty without one
  [[nodiscard]] const simreel::sim::LifePlan& plan() const { return plan_; }

 private:
  void paint(long generation);
  void fade();

  simreel::sim::LifePlan plan_;
  std::vector<std::uint32_t> next_;
};

#pragma once
#include "sim/life/plan.hpp"
#include "sim/life/rle.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

/// Returns the next generation by a plain loop over neighbours, which is simple enough to check by reading.
/// Uses one byte per cell and rows without padding.
std::vector<std::uint8_t> nextBytes(const std::vector<std::uint8_t>& cells, glm::ivec2 size,
                                    const simreel::sim::LifeRule& rule, bool torus);
/// Computes the next generation of B3/S23 on a torus, optimized for one byte per cell. A single loop, which
/// compilers vectorize, handles a whole row. `cells` has size.y + 2 rows of size.x + 2 bytes. This function
/// fills the ghost cells at the borders.
void fastBytes(std::vector<std::uint8_t>& cells, std::vector<std::uint8_t>& next, glm::ivec2 size);

/// These functions convert between bits in blocked rows (sim::CellRows) and bytes without padding.
std::vector<std::uint8_t> bytesOf(const std::vector<std::uint32_t>& words, glm::ivec2 size);
std::vector<std::uint32_t> wordsOf(const std::vector<std::uint8_t>& cells, glm::ivec2 size);

/// CPU twin of Life automata. It runs the kernels' own logic (glsl/life/model.glsl compiled as C++) on 64
/// cells at once. Equals the GPU bit for bit.
class LifeTwin {
 public:
  /// `start`: time of the first state in seconds.
  explicit LifeTwin(simreel::sim::LifePlan plan, double start = 0);

  /// Steps one frame that starts at `time` (seconds). `threads`: number of threads; 0 to use all
  /// processors.
  void step(double time, int threads = 1);
  /// Computes one generation of the rule, without strokes and trail.
  void generation(int threads = 1);

  std::vector<std::uint32_t> words;  ///< cells in the GPU's memory layout
  std::vector<std::uint32_t> trail;  ///< trail with four cells per word; empty if there is no trail
  [[nodiscard]] const simreel::sim::LifePlan& plan() const { return plan_; }

 private:
  void paint(long generation);
  void fade();

  simreel::sim::LifePlan plan_;
  std::vector<std::uint32_t> next_;
};

#pragma once
#include "sim/life/plan.hpp"
#include "sim/life/rle.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

/// Computes a generation with one byte per cell and a plain loop over neighbours, so that it can be
/// verified by reading. Rows without gaps.
std::vector<std::uint8_t> nextBytes(const std::vector<std::uint8_t>& cells, glm::ivec2 size,
                                    const simreel::sim::LifeRule& rule, bool torus);
/// Computes a generation of B3/S23 on a torus in the fastest plain way with one byte per cell: rows have a
/// ghost cell at each end, so that compilers vectorise the loop over whole rows. `cells` has size.y + 2
/// rows of size.x + 2 bytes; this function fills the ghost cells.
void fastBytes(std::vector<std::uint8_t>& cells, std::vector<std::uint8_t>& next, glm::ivec2 size);

/// Converts bits of blocked rows (sim::CellRows) to bytes without gaps, and back.
std::vector<std::uint8_t> bytesOf(const std::vector<std::uint32_t>& words, glm::ivec2 size);
std::vector<std::uint32_t> wordsOf(const std::vector<std::uint8_t>& cells, glm::ivec2 size);

/// Automata on the CPU: the kernels' logic (glsl/life/model.glsl compiled as C++) on 64 cells at once.
/// Equals the GPU bit for bit.
class LifeTwin {
 public:
  /// `start` is the time (s) of the first state.
  explicit LifeTwin(simreel::sim::LifePlan plan, double start = 0);

  /// Simulates a frame that starts at `time` (s). `threads` 0: all processors.
  void step(double time, int threads = 1);
  /// Computes one generation of the rule, without strokes and trail.
  void generation(int threads = 1);

  std::vector<std::uint32_t> words;  ///< cells in the GPU's layout
  std::vector<std::uint32_t> trail;  ///< trail values, four cells per word; empty without a trail
  [[nodiscard]] const simreel::sim::LifePlan& plan() const { return plan_; }

 private:
  void paint(long generation);
  void fade();

  simreel::sim::LifePlan plan_;
  std::vector<std::uint32_t> next_;
};

#pragma once
#include "sim/automata/engine/grid_shape.hpp"
#include "sim/automata/rule/cell_rule.hpp"
#include "sim/life/cell_pattern.hpp"
#include "sim/life/parameters.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// The part of an automaton that the CPU computes: its rule, initial state and the times of its steps. The
/// GPU simulation and its CPU reference both use it.
class LifePlan {
 public:
  /// Reads the patterns. Throws UserError for a pattern that is unreadable, names an unknown rule or does
  /// not fit into the grid.
  LifePlan(LifeParameters parameters, const std::string& object, int seed, double frameSeconds);

  [[nodiscard]] const LifeParameters& parameters() const { return parameters_; }
  [[nodiscard]] const CellRule& rule() const { return rule_; }
  [[nodiscard]] GridShape shape() const { return parameters_.shape(); }
  /// Returns true if LifeStepper supports the automaton: two states, eight neighbours, and either a torus
  /// without shift or dead borders.
  [[nodiscard]] bool plain() const {
    return rule_.onBits() && shape().shift == glm::ivec2(0) &&
           (parameters_.border == GridBorder::torus || parameters_.border == GridBorder::dead);
  }
  [[nodiscard]] bool torus() const { return parameters_.border == LifeBorder::torus; }
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  [[nodiscard]] int seed() const { return seed_; }

  /// Returns the number of 128-cell blocks in a row; each row starts with a new block.
  [[nodiscard]] int rowBlocks() const { return (parameters_.size.x + 127) / 128; }
  [[nodiscard]] long blocks() const { return long{rowBlocks()} * parameters_.size.y; }
  /// Returns the fraction of cells that the random fill makes alive, multiplied by 2^24.
  [[nodiscard]] int fillFraction() const;
  [[nodiscard]] bool hasPatterns() const { return !parameters_.patterns.empty(); }
  /// Sets the live cells of the patterns in `words`.
  void addPatterns(std::vector<std::uint32_t>& words) const;
  /// Returns the initial state of a two-state automaton. Its rows consist of whole blocks of 128 bits.
  [[nodiscard]] std::vector<std::uint32_t> firstCells() const;

  /// Returns the initial state as one byte per cell. Its rows consist of whole blocks of 16 bytes.
  [[nodiscard]] std::vector<std::uint8_t> firstStates() const;
  /// Returns the linear RGB colour of each state if there are more than two states.
  [[nodiscard]] std::vector<glm::vec3> stateColors() const;

  /// Returns the number of generations, counted from time 0, that must be complete at the start of a frame:
  /// floor(time * stepsPerSecond), with a tolerance for the rounding error of the product.
  [[nodiscard]] long generationAt(long frame) const;
  /// Returns the maximum number of generations in a frame.
  [[nodiscard]] int stepsPerFrame() const;
  /// Returns the index of the frame that starts at `time` (seconds).
  [[nodiscard]] long frameAt(double time) const;
  /// Returns the strokes that paint into a generation after it has been computed.
  [[nodiscard]] std::vector<shader::Stroke> strokesInto(long generation) const;

 private:
  [[nodiscard]] const CellPattern& cellsOf(const LifePattern& pattern) const;
  void takeRule(const std::string& object);
  void fitGrid();
  void checkPlaces(const std::string& object) const;
  void checkLiving(const std::string& object) const;
  void checkStates(const std::string& object) const;
  void resolveNames();

  LifeParameters parameters_;
  int seed_;
  double frameSeconds_;
  CellRule rule_;
  Strokes strokes_;
  std::map<std::filesystem::path, CellPattern> files_;  ///< patterns by file, so that a file that is listed
                                                        ///< several times is read only once
};

}  // namespace simreel::sim

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

/// What an automaton is told, worked out on the CPU: its rule, first state and when it steps. Shared with
/// the twin.
class LifePlan {
 public:
  /// Reads the patterns. Throws UserError for one that cannot be read, names an unknown rule, or does not
  /// fit the grid.
  LifePlan(LifeParameters parameters, const std::string& object, int seed, double frameSeconds);

  [[nodiscard]] const LifeParameters& parameters() const { return parameters_; }
  [[nodiscard]] const CellRule& rule() const { return rule_; }
  [[nodiscard]] GridShape shape() const { return parameters_.shape(); }
  /// Whether LifeStepper does: two states, eight neighbours, a plain torus or dead borders.
  [[nodiscard]] bool plain() const {
    return rule_.onBits() && shape().shift == glm::ivec2(0) &&
           (parameters_.border == GridBorder::torus || parameters_.border == GridBorder::dead);
  }
  [[nodiscard]] bool torus() const { return parameters_.border == LifeBorder::torus; }
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  [[nodiscard]] int seed() const { return seed_; }

  /// Blocks of 128 cells in a row; a row starts with a new block.
  [[nodiscard]] int rowBlocks() const { return (parameters_.size.x + 127) / 128; }
  [[nodiscard]] long blocks() const { return long{rowBlocks()} * parameters_.size.y; }
  /// 2^24 times the share that the random fill leaves alive.
  [[nodiscard]] int fillFraction() const;
  [[nodiscard]] bool hasPatterns() const { return !parameters_.patterns.empty(); }
  /// Adds the living cells of the patterns.
  void addPatterns(std::vector<std::uint32_t>& words) const;
  /// The whole first state of two states; rows of whole blocks of 128 bits.
  [[nodiscard]] std::vector<std::uint32_t> firstCells() const;

  /// The whole first state as bytes; rows of whole blocks of 16.
  [[nodiscard]] std::vector<std::uint8_t> firstStates() const;
  /// Linear RGB of each state, of more than two.
  [[nodiscard]] std::vector<glm::vec3> stateColors() const;

  /// Generations due by the start of a frame, counted from time 0: floor(time * stepsPerSecond), rounding
  /// errors of the product aside.
  [[nodiscard]] long generationAt(long frame) const;
  /// Most generations in a frame.
  [[nodiscard]] int stepsPerFrame() const;
  /// The frame that starts at this time (s).
  [[nodiscard]] long frameAt(double time) const;
  /// Strokes that paint into a generation, once it is there.
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
  std::map<std::filesystem::path, CellPattern> files_;  ///< the same gun many times is read once
};

}  // namespace simreel::sim

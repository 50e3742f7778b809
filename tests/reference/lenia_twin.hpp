#pragma once
#include "sim/lenia/plan.hpp"

#include <vector>

/// A continuous automaton on the CPU: the kernel's own arithmetic in its order. Equals the GPU bit for bit.
class LeniaTwin {
 public:
  explicit LeniaTwin(simreel::sim::LeniaPlan plan);
  void step();
  std::vector<glm::vec4> cells;  ///< as the GPU has them

 private:
  simreel::sim::LeniaPlan plan_;
};

/// The same equations stated again in double, neighbour by neighbour; a value a cell, rows without gaps.
class LeniaInDouble {
 public:
  explicit LeniaInDouble(const simreel::sim::LeniaPlan& plan);
  void step();
  std::vector<double> cells;

 private:
  [[nodiscard]] double growth(std::size_t k, double u) const;
  glm::ivec2 size_;
  simreel::sim::LeniaParameters p_;
  std::vector<std::vector<double>> weights_;
  int range_ = 0;
};

#pragma once
#include "sim/lenia/plan.hpp"

#include <vector>

/// CPU twin of a continuous automaton (Lenia or SmoothLife). Runs the arithmetic of the kernels
/// (glsl/lenia/model.glsl, compiled as C++) in the same order, so its cells equal the GPU's bit for bit.
class LeniaTwin {
 public:
  explicit LeniaTwin(simreel::sim::LeniaPlan plan);
  void step();
  std::vector<glm::vec4> cells;  ///< cells in the GPU's memory layout

 private:
  simreel::sim::LeniaPlan plan_;
};

/// SmoothLife in double precision, written from its paper (Rafler 2011, arXiv:1111.1567) without the code
/// of the program. M and N are the means over the inner disc and the outer ring, s is the transition
/// function from sigma_1, sigma_2 and sigma_m, and a step of the length dt changes a cell f to f + dt (2 s
/// - 1). `cells` has one value per cell; its rows have no padding.
class SmoothLifeInDouble {
 public:
  explicit SmoothLifeInDouble(const simreel::sim::LeniaPlan& plan);
  void step();
  std::vector<double> cells;

 private:
  [[nodiscard]] double at(int x, int y) const;
  glm::ivec2 size_;
  simreel::sim::LeniaParameters p_;
};

/// Lenia's equations in double precision, written as plain sums over neighbours without the code of the
/// program. `cells` has one value per cell; its rows have no padding.
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

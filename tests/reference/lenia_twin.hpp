#pragma once
#include "sim/lenia/plan.hpp"

#include <vector>

/// CPU twin of a continuous automaton. It runs the kernel's own arithmetic in the same order. Equals the
/// GPU bit for bit.
class LeniaTwin {
 public:
  explicit LeniaTwin(simreel::sim::LeniaPlan plan);
  void step();
  std::vector<glm::vec4> cells;  ///< cells in the GPU's memory layout

 private:
  simreel::sim::LeniaPlan plan_;
};

/// SmoothLife in double precision, implemented independently from its paper (Rafler 2011, arXiv:1111.1567).
/// It has the equations of M, N, sigma_1, sigma_2, sigma_m and s, and smooth steps f + dt (2 s - 1). There
/// is one value per cell. Rows have no padding.
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

/// Lenia's equations in double precision, implemented independently as sums over neighbours. There is one
/// value per cell. Rows have no padding.
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

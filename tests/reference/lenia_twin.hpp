#pragma once
#include "sim/lenia/plan.hpp"

#include <vector>

/// A continuous automaton on the CPU: the kernel's arithmetic in the same order. Equals the GPU bit for
/// bit.
class LeniaTwin {
 public:
  explicit LeniaTwin(simreel::sim::LeniaPlan plan);
  void step();
  std::vector<glm::vec4> cells;  ///< cells in the GPU's layout

 private:
  simreel::sim::LeniaPlan plan_;
};

/// SmoothLife as in its paper (Rafler 2011, arXiv:1111.1567: eqs. of M, N, sigma_1, sigma_2, sigma_m and s;
/// smooth steps f + dt (2 s - 1)), in double precision; one value per cell, rows without gaps.
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

/// Lenia's equations implemented independently in double precision, neighbour by neighbour; one value per
/// cell, rows without gaps.
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

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

/// SmoothLife as its paper has it (Rafler 2011, arXiv:1111.1567: eqs. of M, N, sigma_1, sigma_2, sigma_m
/// and s; smooth steps f + dt (2 s - 1)), in double; a value a cell, rows without gaps.
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

/// Lenia's equations stated again in double, neighbour by neighbour; a value a cell, rows without gaps.
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

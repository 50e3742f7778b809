#pragma once
#include "sim/fluid/parameters.hpp"

#include <functional>
#include <span>
#include <vector>

/// Flows that others have computed or measured, as fluids of this program, and what is known of them.
/// Shared by tests and tools/bench/fluid.cpp.
namespace flows {

/// Forces on a cylinder over time.
struct Wake {
  std::vector<double> times, drag, lift;  ///< s; coefficients 2 F / (U^2 D)

  /// Of the last `seconds`: greatest, by parabolas through samples.
  [[nodiscard]] double mostDrag(double seconds) const;
  [[nodiscard]] double meanDrag(double seconds) const;
  [[nodiscard]] double mostLift(double seconds) const;
  /// Frequency (1/s), by the lift's zeros on the way up.
  [[nodiscard]] double frequency(double seconds) const;
};

/// A cylinder in a flow: what of it is given, and what its figures go by.
struct Cylinder {
  simreel::sim::FluidParameters parameters;
  double diameter, speed;  ///< cells, cells/s
  double frame;            ///< s
};

/// Schaefer and Turek (1996), "Benchmark computations of laminar flow around a cylinder", 2D-2: a channel
/// of 2.2 x 0.41, a cylinder of 0.1 at (0.2, 0.2), a parabola of 1.5 in the middle, mean speed 1, Re 100;
/// in metres and seconds. `n`: cells a diameter.
[[nodiscard]] Cylinder schaeferTurek(int n);
/// Re 100 between slip sides 30 diameters apart.
[[nodiscard]] Cylinder wideChannel(int n);
/// What a simulation's quantities say after a frame, as `measure` gives them.
void note(Wake& wake, const Cylinder& cylinder, double time, std::span<const double> quantities);

/// A square cavity of n x n cells whose top moves at n cells/s.
[[nodiscard]] simreel::sim::FluidParameters cavity(int n, double reynolds);

/// Ghia, Ghia and Shin (1982), tables I and II, without the ends: u along the vertical through the middle,
/// v along the horizontal; y and v up, over the lid's speed.
struct Ghia {
  double reynolds;
  std::vector<double> u, v;
};
[[nodiscard]] const Ghia& ghia(double reynolds);
/// Greatest difference from the tables. `flow`: cells with their ring. A misprint of theirs, v(0.9063) at
/// Re 400, is left out. `where`, if given, gets all differences, u's first.
[[nodiscard]] double ghiaError(const Ghia& table, int n, std::span<const glm::vec4> flow,
                               std::vector<double>* where = nullptr);

/// Extremes through a cavity's middle: of u along the vertical the least, of v the most and the least.
/// By parabolas through three nodes.
struct Extremes {
  double u, most, least;
};
[[nodiscard]] Extremes extremesOf(int n, std::span<const glm::vec4> flow);
/// Botella and Peyret (1998), "Benchmark spectral results on the lid-driven cavity flow", Re 1000.
inline constexpr Extremes botellaPeyret{-0.3885698, 0.3769447, -0.5270771};

}  // namespace flows

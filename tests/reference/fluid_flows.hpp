#pragma once
#include "sim/fluid/parameters.hpp"

#include <functional>
#include <span>
#include <vector>

/// Reference flows from the literature, as fluids of this program, with the published results. Shared by
/// tests and tools/bench/fluid.cpp.
namespace flows {

/// Forces on a cylinder over time.
struct Wake {
  std::vector<double> times, drag, lift;  ///< seconds; coefficients 2 F / (U^2 D)

  /// Max drag, mean drag and max lift over the last `seconds`. A max is refined by a parabola through
  /// samples.
  [[nodiscard]] double mostDrag(double seconds) const;
  [[nodiscard]] double meanDrag(double seconds) const;
  [[nodiscard]] double mostLift(double seconds) const;
  /// Returns the frequency (1/s) from the lift's upward zero crossings.
  [[nodiscard]] double frequency(double seconds) const;
};

/// A cylinder in a channel: the fluid's parameters, and the scales of its coefficients.
struct Cylinder {
  simreel::sim::FluidParameters parameters;
  double diameter, speed;  ///< cells, cells/s
  double frame;            ///< frame time in seconds
};

/// Returns case 2D-2 of Schaefer and Turek (1996), "Benchmark computations of laminar flow around a
/// cylinder", in metres and seconds: a channel of 2.2 x 0.41, a cylinder of diameter 0.1 at (0.2, 0.2), a
/// parabolic inflow with peak 1.5 and mean speed 1, Re 100. `n`: cells per diameter.
[[nodiscard]] Cylinder schaeferTurek(int n);
/// Returns a cylinder at Re 100 between slip sides 30 diameters apart.
[[nodiscard]] Cylinder wideChannel(int n);
/// Appends drag and lift of a frame from the simulation's quantities, as `measure` returns them.
void note(Wake& wake, const Cylinder& cylinder, double time, std::span<const double> quantities);

/// Returns a square cavity of n x n cells whose top moves at n cells/s.
[[nodiscard]] simreel::sim::FluidParameters cavity(int n, double reynolds);

/// Tables I and II of Ghia, Ghia and Shin (1982) without their end points: u along the vertical centre
/// line, v along the horizontal one, both divided by the lid's speed; y and v point upwards.
struct Ghia {
  double reynolds;
  std::vector<double> u, v;
};
[[nodiscard]] const Ghia& ghia(double reynolds);
/// Returns the max difference from the tables. `flow` includes the ring of border cells. The misprint
/// v(0.9063) at Re 400 is skipped. If `where` is not null, it receives all differences, first for u.
[[nodiscard]] double ghiaError(const Ghia& table, int n, std::span<const glm::vec4> flow,
                               std::vector<double>* where = nullptr);

/// Extrema on a cavity's centre lines: the min of u on the vertical one, and the max and min of v on the
/// horizontal one. Refined by parabolas through three nodes.
struct Extremes {
  double u, most, least;
};
[[nodiscard]] Extremes extremesOf(int n, std::span<const glm::vec4> flow);
/// Botella and Peyret (1998), "Benchmark spectral results on the lid-driven cavity flow", Re 1000.
inline constexpr Extremes botellaPeyret{-0.3885698, 0.3769447, -0.5270771};

}  // namespace flows

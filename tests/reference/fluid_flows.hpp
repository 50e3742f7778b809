#pragma once
#include "sim/fluid/parameters.hpp"

#include <functional>
#include <span>
#include <vector>

/// Flows computed or measured by others, as fluids of this program, with the published results. Shared by
/// tests and tools/bench/fluid.cpp.
namespace flows {

/// Forces on a cylinder over time.
struct Wake {
  std::vector<double> times, drag, lift;  ///< times in s; coefficients of drag and lift, 2 F / (U^2 D)

  /// Maxima and mean over the last `seconds`; maxima by parabolas through samples.
  [[nodiscard]] double mostDrag(double seconds) const;
  [[nodiscard]] double meanDrag(double seconds) const;
  [[nodiscard]] double mostLift(double seconds) const;
  /// Returns the frequency (1/s), from the lift's upward zero crossings.
  [[nodiscard]] double frequency(double seconds) const;
};

/// A cylinder in a flow: the simulation's parameters, and the reference values of its coefficients.
struct Cylinder {
  simreel::sim::FluidParameters parameters;
  double diameter, speed;  ///< diameter in cells, speed in cells/s
  double frame;            ///< duration of a frame, s
};

/// Schaefer and Turek (1996), "Benchmark computations of laminar flow around a cylinder", 2D-2: a channel
/// of 2.2 x 0.41 m, a cylinder of diameter 0.1 m at (0.2, 0.2), a parabolic inflow of maximum 1.5 m/s and
/// mean 1 m/s, Re 100. `n`: cells per diameter.
[[nodiscard]] Cylinder schaeferTurek(int n);
/// A cylinder at Re 100 between slip walls 30 diameters apart.
[[nodiscard]] Cylinder wideChannel(int n);
/// Adds the simulation's quantities after a frame, as returned by `measure`, to the wake.
void note(Wake& wake, const Cylinder& cylinder, double time, std::span<const double> quantities);

/// A square cavity of n x n cells whose lid moves at n cells/s.
[[nodiscard]] simreel::sim::FluidParameters cavity(int n, double reynolds);

/// Ghia, Ghia and Shin (1982), tables I and II without the end points: u along the vertical centre line, v
/// along the horizontal one; y and v point up, speeds relative to the lid's.
struct Ghia {
  double reynolds;
  std::vector<double> u, v;
};
[[nodiscard]] const Ghia& ghia(double reynolds);
/// Returns the maximum difference from the tables. `flow` is the cells with their border ring. Leaves out
/// v(0.9063) at Re 400, a misprint. If given, `where` receives all differences, those in u first.
[[nodiscard]] double ghiaError(const Ghia& table, int n, std::span<const glm::vec4> flow,
                               std::vector<double>* where = nullptr);

/// Extrema on the centre lines of a cavity: the minimum of u on the vertical, maximum and minimum of v on
/// the horizontal. Interpolated by parabolas through three nodes.
struct Extremes {
  double u, most, least;
};
[[nodiscard]] Extremes extremesOf(int n, std::span<const glm::vec4> flow);
/// Botella and Peyret (1998), "Benchmark spectral results on the lid-driven cavity flow", Re 1000.
inline constexpr Extremes botellaPeyret{-0.3885698, 0.3769447, -0.5270771};

}  // namespace flows

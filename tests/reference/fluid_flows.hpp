#pragma once
#include "sim/fluid/parameters.hpp"

#include <functional>
#include <span>
#include <vector>

/// Reference flows from the literature in the form of this program's fluids, with the published results.
/// Tests and tools/bench/fluid.cpp use them.
namespace flows {

/// Forces on a cylinder over time.
struct Wake {
  std::vector<double> times, drag, lift;  ///< times in seconds; drag and lift as coefficients 2 F / (U^2 D)
                                          ///< of the force F, with speed U and diameter D

  /// These functions return the maximum drag, the mean drag and the maximum lift over the last `seconds`. A
  /// maximum is refined by a parabola through samples.
  [[nodiscard]] double maxDrag(double seconds) const;
  [[nodiscard]] double meanDrag(double seconds) const;
  [[nodiscard]] double maxLift(double seconds) const;
  /// Returns the frequency (1/s) of the lift over the last `seconds`, from its upward zero crossings.
  [[nodiscard]] double frequency(double seconds) const;
};

/// A cylinder in a channel: parameters of the fluid, and the scales for the coefficients.
struct Cylinder {
  simreel::sim::FluidParameters parameters;
  double diameter, speed;  ///< diameter in cells, and speed in cells/s
  double frame;            ///< duration of a frame in seconds
};

/// Returns case 2D-2 of Schaefer and Turek (1996), "Benchmark computations of laminar flow around a
/// cylinder", in metres and seconds. The channel is 2.2 long and 0.41 high. The cylinder has the diameter
/// 0.1 and its centre at (0.2, 0.2). The inflow is parabolic with peak speed 1.5 and mean speed 1, and Re
/// is 100. `n`: number of cells per diameter.
[[nodiscard]] Cylinder schaeferTurek(int n);
/// Returns a cylinder at Re 100 between two slip sides that are 30 diameters apart. `n`: cells per
/// diameter.
[[nodiscard]] Cylinder wideChannel(int n);
/// Appends drag and lift of a frame from the simulation's quantities, in the order in which `measure`
/// returns them.
void note(Wake& wake, const Cylinder& cylinder, double time, std::span<const double> quantities);

/// Returns a square cavity of n x n cells whose top moves at n cells/s.
[[nodiscard]] simreel::sim::FluidParameters cavity(int n, double reynolds);

/// Tables I and II of Ghia, Ghia and Shin (1982) without the end points. They contain u along the vertical
/// centre line and v along the horizontal one, both divided by the lid's speed. y and v point upwards.
struct Ghia {
  double reynolds;
  std::vector<double> u, v;
};
[[nodiscard]] const Ghia& ghia(double reynolds);
/// Returns the maximum difference from the tables. `flow` includes the ring of border cells. Skips
/// v(0.9063) at Re 400, which is misprinted. `where`: if not null, receives all differences, starting with
/// the differences of u.
[[nodiscard]] double ghiaError(const Ghia& table, int n, std::span<const glm::vec4> flow,
                               std::vector<double>* where = nullptr);

/// Extrema on the centre lines of a cavity. These are the minimum of u on the vertical line, and the
/// maximum and minimum of v on the horizontal line. They are refined by parabolas through three nodes.
struct Extremes {
  double u, maximum, minimum;
};
[[nodiscard]] Extremes extremesOf(int n, std::span<const glm::vec4> flow);
/// Results of Botella and Peyret (1998), "Benchmark spectral results on the lid-driven cavity flow", for Re
/// 1000.
inline constexpr Extremes botellaPeyret{-0.3885698, 0.3769447, -0.5270771};

}  // namespace flows

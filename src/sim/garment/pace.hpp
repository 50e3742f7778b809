#pragma once
#include "sim/cloth/parameters.hpp"
#include "sim/garment/membrane.hpp"
#include "sim/garment/plate.hpp"
#include "sim/garment/triangles.hpp"

#include <map>
#include <string>
#include <vector>

namespace simreel::sim {

/// Chooses the number of substeps for cloth of a mesh.
///
/// Constraints are relaxed forward and back once per substep (XPBD with small steps, Macklin et al. 2019),
/// with the time step h = constraintPart * seconds. Cloth that hangs at rest falls by g h^2 per substep and
/// is pulled back by the same distance. A face therefore carries the tension T per width only once it is
/// stretched by e = T A S h^2 / 2 in addition to its compliance's stretch, where S is the sum of its
/// corners' inverse masses times their squared gradients. If the length d hangs on the face, T = rho g d,
/// so the average over that length is e = 1/4 rho g d A S h^2.
///
/// "auto" keeps that error below 1/2 %, or below 5 % if attachments (attachments.hpp) hold the cloth: they
/// hold it straight, but are slack if swinging cloth is taut along a curve.
struct GarmentPace {
  GarmentPace(const ClothParameters& parameters, const ClothTriangles& cloth,
              const std::vector<MembraneElement>& membrane, const std::vector<double>& masses,
              const std::vector<bool>& pinned, const std::multimap<unsigned, unsigned>& links);

  double hanging = 0;       ///< length d in metres (see hangingLength()); a length held by attachments
                            ///< counts by a tenth
  double stiffening = 0;    ///< product rho a d A S in 1/s^2, where a is the acceleration by the greatest
                            ///< load
  double drag = 0;          ///< rate in 1/s at which the fastest air drags the cloth
  double softening = 1;     ///< ratio of softeningSeconds() to its argument
  double steadyPart = 0.7;  ///< fraction of the stable substep that "auto" takes, the same as for grids
  [[nodiscard]] double stretchError(double seconds) const {
    const double reach = constraintPart * softening * seconds;
    return 0.25 * stiffening * reach * reach;
  }
  /// Returns the longest stable substep in seconds, limited by hanging cloth that swings sideways, in the
  /// fastest air. Cloth held by attachments is stable, too: the tension of its faces is k_e e at the
  /// stretch e, and k_e A S h^2 <= 1, so w^2 h^2 <= 4 e.
  [[nodiscard]] double stableSeconds() const;
  /// Returns the number of substeps per frame for "auto", at least `fewest`. `bendingSquared` (1/s^2): the
  /// result of plateFrequencySquared().
  [[nodiscard]] int substeps(double frameSeconds, double bendingSquared, int fewest = 8) const;
};

/// Returns for each vertex the length in metres of which hangingLength() returns the maximum.
[[nodiscard]] std::vector<double> hangingWays(const ClothTriangles& cloth, const std::vector<bool>& pinned,
                                              const std::multimap<unsigned, unsigned>& links);

/// Returns the maximum over all vertices of the shortest path along edges to a pin of the same piece, in
/// metres. For a piece without pins: half of the path between two vertices far apart. `links` connect
/// vertices at zero distance, in both directions (seams).
[[nodiscard]] double hangingLength(const ClothTriangles& cloth, const std::vector<bool>& pinned,
                                   const std::multimap<unsigned, unsigned>& links);

/// Returns the largest squared bending frequency (1/s^2) that an explicit step of `seconds` tolerates.
[[nodiscard]] constexpr double mostBending(double seconds) {
  return 2.0 / (seconds * seconds);
}

}  // namespace simreel::sim

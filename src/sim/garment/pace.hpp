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
/// is pulled back by the same distance. A face therefore carries the tension T per width only when it is
/// stretched by e = T A S h^2 / 2 in addition to the stretch of its compliance, where A is the area and S
/// is the sum over its corners of the inverse mass times the squared gradient. If cloth of the length d and
/// the density rho hangs from the face, T = rho g d, so the mean over that length is e = 1/4 rho g d A S
/// h^2.
///
/// "auto" keeps that error below 0.5 %, or below 5 % if attachments (attachments.hpp) hold the cloth.
/// Attachments hold the cloth straight, but they are slack while swinging cloth is taut along a curve.
struct GarmentPace {
  GarmentPace(const ClothParameters& parameters, const ClothTriangles& cloth,
              const std::vector<MembraneElement>& membrane, const std::vector<double>& masses,
              const std::vector<bool>& pinned, const std::multimap<unsigned, unsigned>& links);

  double hanging = 0;       ///< length d in metres (see hangingLength()); a length held by attachments
                            ///< counts only as a tenth
  double stiffening = 0;    ///< product rho a d A S in 1/s^2, where a is the maximum acceleration by
                            ///< gravity and wind
  double drag = 0;          ///< rate in 1/s at which the fastest air slows the cloth
  double softening = 1;     ///< ratio of softeningSeconds() to its argument
  double steadyPart = 0.7;  ///< fraction of the maximum stable substep that "auto" uses; the same value as
                            ///< for grids
  [[nodiscard]] double stretchError(double seconds) const {
    const double reach = constraintPart * softening * seconds;
    return 0.25 * stiffening * reach * reach;
  }
  /// Returns the maximum stable substep in seconds in the fastest air, limited by the sideways swings of
  /// hanging cloth. Cloth held by attachments is also stable: at the stretch e, the tension of its faces is
  /// k_e e with k_e A S h^2 <= 1, so w^2 h^2 <= 4 e for the frequency w of a swing.
  [[nodiscard]] double stableSeconds() const;
  /// Returns the number of substeps per frame for "auto", at least `fewest`. `bendingSquared` (1/s^2) is
  /// the result of plateFrequencySquared().
  [[nodiscard]] int substeps(double frameSeconds, double bendingSquared, int fewest = 8) const;
};

/// Returns, for each vertex, the path length in metres of which hangingLength() returns the maximum.
[[nodiscard]] std::vector<double> hangingLengths(const ClothTriangles& cloth,
                                                 const std::vector<bool>& pinned,
                                                 const std::multimap<unsigned, unsigned>& links);

/// Returns the maximum over all vertices of the shortest path along edges to a pin of the same piece, in
/// metres. For a piece without pins, the length is half of the path between two vertices that are far
/// apart. `links` (seams) connect vertices at zero distance; each connection is listed in both directions.
[[nodiscard]] double hangingLength(const ClothTriangles& cloth, const std::vector<bool>& pinned,
                                   const std::multimap<unsigned, unsigned>& links);

/// Returns the maximum squared bending frequency (1/s^2) for which an explicit step of `seconds` is stable.
[[nodiscard]] constexpr double maxBending(double seconds) {
  return 2.0 / (seconds * seconds);
}

}  // namespace simreel::sim

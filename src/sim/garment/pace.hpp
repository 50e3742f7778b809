#pragma once
#include "sim/cloth/parameters.hpp"
#include "sim/garment/membrane.hpp"
#include "sim/garment/plate.hpp"
#include "sim/garment/triangles.hpp"

#include <map>
#include <string>
#include <vector>

namespace simreel::sim {

/// How finely time is cut for cloth of a mesh.
///
/// Constraints are relaxed there and back once a substep (XPBD with small steps, Macklin et al. 2019), h
/// being constraintPart of its seconds. What hangs at rest falls by g h^2 a substep and is pulled back
/// through the same: a face carries the tension T per width only once it is stretched by e = T A S h^2 / 2
/// beyond what its compliance gives, where S is the sum of its corners' inverse masses times the squares of
/// its gradients. T = rho g d where the length d hangs on it, so that on the average over that length e =
/// 1/4 rho g d A S h^2. "auto" keeps that below 1/2 %, and where pins hold it by attachments
/// (attachments.hpp) below 5 %: these hold it straight, but are slack where cloth that swings is taut along
/// a curve.
struct GarmentPace {
  GarmentPace(const ClothParameters& parameters, const ClothTriangles& cloth,
              const std::vector<MembraneElement>& membrane, const std::vector<double>& masses,
              const std::vector<bool>& pinned, const std::multimap<unsigned, unsigned>& links);

  double hanging = 0;       ///< m, d: hangingLength; where attachments hold it only a tenth counts
  double stiffening = 0;    ///< 1/s^2, rho a d A S
  double drag = 0;          ///< 1/s
  double softening = 1;     ///< ratio of softeningSeconds to seconds
  double steadyPart = 0.7;  ///< of the stable substep that "auto" takes, as of grids
  [[nodiscard]] double stretchError(double seconds) const {
    const double reach = constraintPart * softening * seconds;
    return 0.25 * stiffening * reach * reach;
  }
  /// Longest substep (s) that is stable: of what hangs straight and swings sideways, in the fastest air.
  /// What attachments hold is: its faces have the tension k_e e of their stretch e, and k_e A S h^2 <= 1,
  /// so that w^2 h^2 <= 4 e.
  [[nodiscard]] double stableSeconds() const;
  /// Substeps of a frame for "auto". `bendingSquared` (1/s^2): of plateFrequencySquared.
  [[nodiscard]] int substeps(double frameSeconds, double bendingSquared, int fewest = 8) const;
};

/// m: the ways of hangingLength, of each vertex.
[[nodiscard]] std::vector<double> hangingWays(const ClothTriangles& cloth, const std::vector<bool>& pinned,
                                              const std::multimap<unsigned, unsigned>& links);

/// m: the longest of all shortest ways along edges from a vertex to the pins of its piece; of a piece
/// without any, half of the way between two vertices far apart. `links` join vertices, both ways, without
/// any length: seams.
[[nodiscard]] double hangingLength(const ClothTriangles& cloth, const std::vector<bool>& pinned,
                                   const std::multimap<unsigned, unsigned>& links);

/// Of an explicit step of that many seconds: what squared frequencies of bending keep to (1/s^2).
[[nodiscard]] constexpr double mostBending(double seconds) {
  return 2.0 / (seconds * seconds);
}

}  // namespace simreel::sim

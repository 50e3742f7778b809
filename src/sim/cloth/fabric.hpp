#pragma once
#include "glsl/common/cpp.hpp"
#include "scene/fields.hpp"

#include <optional>

namespace simreel::shader {
#include "glsl/cloth/types.glsl"
}

namespace simreel::sim {

/// Constraints act as in a step of that part of a substep's seconds (glsl/cloth/motion.glsl).
inline constexpr double constraintPart = 2.0 / 3;
/// Of lines whose constraints keep energy (glsl/cloth/keeping.glsl), as a ratio to dt^2 times inverse
/// masses. Rows, columns and pairs that all pull the same way are stable with the least; with the most,
/// what is measured of the energy stays within 1% of what is kept.
inline constexpr double leastSoftening = 1.5;
inline constexpr double mostSoftening = 6;
/// Of pairs; a constant of glsl/cloth/keeping.glsl.
inline constexpr double pairSoftening = 4;

enum class FabricMaterial { cotton, silk, denim, nylon, canvas, rubber };

/// What a material is by itself. Fabrics: what the low-stress tests of Kawabata (KES-F) typically give for
/// the cloth named, rounded; stretch is the chord to 490 N/m, an average over curves that are softer at
/// first. Rubber: a latex sheet of t = 0.5 mm, E = 1.5 MPa, 940 kg/m^3, nu = 1/2: E t, E t / 3, E t^3 / (12
/// (1 - nu^2)).
shader::FabricConstants fabricOf(FabricMaterial material);

/// A sheet by its material, of which any property may be given instead.
struct Fabric {
  FabricMaterial material = FabricMaterial::cotton;
  std::optional<double> density;    ///< kg/m^2
  std::optional<double> weft;       ///< N/m
  std::optional<double> warp;       ///< N/m
  std::optional<double> shear;      ///< N/m
  std::optional<double> bending;    ///< N m
  std::optional<double> thickness;  ///< m
  double stretchDamping = 0;        ///< s: T of stress = k (strain + T d strain / dt)
  void describe(scene::Fields& fields);
  [[nodiscard]] shader::FabricConstants constants() const;
};

}  // namespace simreel::sim

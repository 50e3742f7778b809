#pragma once
#include "glsl/common/cpp.hpp"
#include "scene/value/fields.hpp"

#include <optional>

namespace simreel::shader {
#include "glsl/cloth/types.glsl"
}

namespace simreel::sim {

/// Constraints act as in a step of that part of a substep's seconds (glsl/cloth/motion.glsl).
inline constexpr double constraintPart = 2.0 / 3;
/// Constraints that keep energy (glsl/cloth/keeping.glsl) are softer by so much time squared times inverse
/// masses (s): what vibrates faster than 1 / (this) rad/s along the cloth is slowed down to it. As a ratio
/// to a substep it is what says how near the energy that is measured stays to the one that is kept: 1/12
/// (dt / softSeconds)^2 of what is in those vibrations. A heavy line is held tighter, but not below the
/// least ratio, squared, at which rows, columns and pairs that all pull the same way are stable.
inline constexpr double softSeconds = 1.8e-3;
inline constexpr double keepingSubstep = 1.0 / 1920;  ///< s, the longest that "auto" takes
inline constexpr double leastSoftening = 1.5;
inline constexpr double pairSoftening = 4;  ///< of pairs at least; in glsl/cloth/keeping.glsl, too
/// Ratio of faces of a mesh, six of which meet at a vertex: with half of it a crumpled mesh of uneven
/// faces, all of whose energy is in vibrations, gains a tenth of it in 20 s. They do not get stiffer where
/// they are evenly loaded, as lines do, so "auto" takes shorter substeps.
inline constexpr double faceSoftening = 12;
inline constexpr double keepingFaceSubstep = 1.0 / 2700;
/// Of attachments, ratio: what becomes taut at once gains or loses energy, the less the softer it is.
inline constexpr double attachmentSoftening = 256;

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
  /// Stiffnesses of the links of a grid whose diagonals have the stiffness `diagonal` (N/m): those resist
  /// stretching along rows and columns, too, so the links have what is left of "weft" and "warp", at least
  /// a twentieth.
  [[nodiscard]] shader::FabricConstants ofLinks(double diagonal) const;
};

}  // namespace simreel::sim

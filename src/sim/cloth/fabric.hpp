#pragma once
#include "glsl/common/cpp.hpp"
#include "scene/value/fields.hpp"

#include <optional>

namespace simreel::shader {
#include "glsl/cloth/types.glsl"
}

namespace simreel::sim {

/// Fraction of a substep's duration that serves as the time step of constraints (h = 2/3 dt in
/// glsl/cloth/motion.glsl).
inline constexpr double constraintPart = 2.0 / 3;
/// Softness of constraints that keep energy (glsl/cloth/keeping.glsl), in seconds: their compliance grows
/// by softSeconds^2 times the inverse masses, so vibrations along the cloth faster than 1 / softSeconds
/// rad/s are slowed to that frequency. The measured energy differs from the conserved one by 1/12 (dt /
/// softSeconds)^2 of the energy in these vibrations. A line under a heavy load is softened less, but never
/// below leastSoftening, the smallest ratio (softSeconds / dt)^2 at which rows, columns and pairs that all
/// pull in one direction are stable.
inline constexpr double softSeconds = 1.8e-3;
inline constexpr double keepingSubstep = 1.0 / 1920;  ///< longest substep in seconds that "auto" takes
inline constexpr double leastSoftening = 1.5;
inline constexpr double pairSoftening = 4;  ///< minimum for pairs; the same number is in
                                            ///< glsl/cloth/keeping.glsl
/// Softening of the faces of a mesh, as a ratio; six faces meet at a vertex. With half this value, a
/// crumpled mesh of uneven faces whose whole energy is in vibrations gains a tenth of it in 20 s. Unlike
/// lines, faces do not stiffen under an even load, so "auto" takes shorter substeps for them.
inline constexpr double faceSoftening = 12;
inline constexpr double keepingFaceSubstep = 1.0 / 2700;
/// Softening of attachments, as a ratio. An attachment that becomes taut within one substep gains or loses
/// energy; a softer one gains or loses less.
inline constexpr double attachmentSoftening = 256;

enum class FabricMaterial { cotton, silk, denim, nylon, canvas, rubber };

/// Returns the properties of a material. Fabrics: typical low-stress measurements by the Kawabata system
/// (KES-F) of the named cloth, rounded; the stretch stiffness is the chord to 490 N/m, an average over
/// curves that are softer at first. Rubber: a latex sheet of t = 0.5 mm, E = 1.5 MPa, 940 kg/m^3, nu = 1/2,
/// so the values are E t, E t / 3 and E t^3 / (12 (1 - nu^2)).
shader::FabricConstants fabricOf(FabricMaterial material);

/// Fabric parameters of a scene: a material, any of whose properties can be overridden.
struct Fabric {
  FabricMaterial material = FabricMaterial::cotton;
  std::optional<double> density;    ///< mass per area in kg/m^2
  std::optional<double> weft;       ///< stretch stiffness along rows in N/m
  std::optional<double> warp;       ///< stretch stiffness along columns in N/m
  std::optional<double> shear;      ///< shear stiffness in N/m
  std::optional<double> bending;    ///< bending stiffness in N m
  std::optional<double> thickness;  ///< thickness in metres
  double stretchDamping = 0;        ///< time T in seconds: stress = k (strain + T d strain / dt)
  void describe(scene::Fields& fields);
  [[nodiscard]] shader::FabricConstants constants() const;
  /// Returns constants with the stiffnesses for the links along rows and columns of a grid whose diagonals
  /// have the stiffness `diagonal` (N/m). Diagonals also resist stretching along rows and columns, so a
  /// link gets the remainder of "weft" or "warp", at least a twentieth of it.
  [[nodiscard]] shader::FabricConstants ofLinks(double diagonal) const;
};

}  // namespace simreel::sim

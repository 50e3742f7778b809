#pragma once
#include "glsl/common/cpp.hpp"
#include "scene/value/fields.hpp"

#include <optional>

namespace simreel::shader {
#include "glsl/cloth/types.glsl"
}

namespace simreel::sim {

/// Time step of constraints as a fraction of the substep's duration (h = 2/3 dt in glsl/cloth/motion.glsl).
inline constexpr double constraintPart = 2.0 / 3;
/// softSeconds is the softness, in seconds, of constraints that keep energy (glsl/cloth/keeping.glsl).
/// Their compliance grows by softSeconds^2 times the inverse masses, so that vibrations along the cloth
/// faster than 1 / softSeconds rad/s are slowed to that frequency. The measured energy differs from the
/// conserved energy by 1/12 (dt / softSeconds)^2 of the energy in these vibrations. A line under a heavy
/// load is softened less, but at least by minSoftening, the minimum ratio (softSeconds / dt)^2 at which
/// rows, columns and pairs that all pull in one direction are stable.
inline constexpr double softSeconds = 1.8e-3;
inline constexpr double keepingSubstep = 1.0 / 1920;  ///< maximum substep in seconds for "auto"
inline constexpr double minSoftening = 1.5;
inline constexpr double pairSoftening = 4;  ///< minimum softening of pairs; glsl/cloth/keeping.glsl has the
                                            ///< same number
/// Softening of the faces of a mesh, as a ratio, for vertices at which six faces meet. With half this
/// value, a crumpled mesh of uneven faces, all of whose energy is in vibrations, gains a tenth of this
/// energy in 20 s. Unlike lines, faces do not become stiffer under an even load, so meshes are less stable
/// and "auto" uses shorter substeps for them.
inline constexpr double faceSoftening = 12;
inline constexpr double keepingFaceSubstep = 1.0 / 2700;
/// Softening of attachments, as a ratio. An attachment that becomes taut within one substep gains or loses
/// energy; the softer it is, the smaller is the change.
inline constexpr double attachmentSoftening = 256;

enum class FabricMaterial { cotton, silk, denim, nylon, canvas, rubber };

/// Returns the properties of a material. For fabrics, they are typical low-stress measurements of the named
/// cloth by the Kawabata system (KES-F), rounded; the stretch stiffness is the slope of the chord up to 490
/// N/m, because the curves are softer at first. Rubber is a latex sheet with the thickness t = 0.5 mm,
/// Young's modulus E = 1.5 MPa, density 940 kg/m^3 and Poisson's ratio nu = 1/2, so its stiffnesses are E t
/// (stretch), E t / 3 (shear) and E t^3 / (12 (1 - nu^2)) (bending).
shader::FabricConstants fabricOf(FabricMaterial material);

/// Fabric parameters of a scene: a material and values that override its properties.
struct Fabric {
  FabricMaterial material = FabricMaterial::cotton;
  std::optional<double> density;    ///< mass per area in kg/m^2
  std::optional<double> weft;       ///< stretch stiffness along rows in N/m
  std::optional<double> warp;       ///< stretch stiffness along columns in N/m
  std::optional<double> shear;      ///< shear stiffness in N/m
  std::optional<double> bending;    ///< bending stiffness in N m
  std::optional<double> thickness;  ///< thickness in metres
  double stretchDamping = 0;        ///< time constant T in seconds: tension = k (strain + T d strain / dt),
                                    ///< where k is the stiffness
  void describe(scene::Fields& fields);
  [[nodiscard]] shader::FabricConstants constants() const;
  /// Returns constants whose stretch stiffnesses apply to the links along rows and columns of a grid whose
  /// diagonals have the stiffness `diagonal` (N/m). Diagonals also resist stretching along rows and
  /// columns, so a link gets "weft" or "warp" minus the part of the diagonals, but at least a twentieth of
  /// "weft" or "warp".
  [[nodiscard]] shader::FabricConstants ofLinks(double diagonal) const;
};

}  // namespace simreel::sim

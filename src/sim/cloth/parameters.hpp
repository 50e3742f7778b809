#pragma once
#include "scene/dressed.hpp"
#include "scene/own_colors.hpp"
#include "scene/value/fields.hpp"
#include "sim/cloth/coloring.hpp"
#include "sim/cloth/fabric.hpp"
#include "sim/cloth/mesh_source.hpp"
#include "sim/collide/mesh_colliders.hpp"
#include "sim/core/kind.hpp"
#include "sim/ports/color_scale.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Part of a body to which pins are attached.
enum class PinPlace { bone, skin };

/// Opposite corners of a box in world space, in metres.
struct PinBox {
  glm::vec3 min{-1}, max{1};
};

/// Group of pinned particles, with the animated transform that moves them.
struct PinGroup {
  std::vector<int> rows;  ///< indices of rows; negative indices count from the end
  std::vector<int> columns;
  std::vector<int> corners;        ///< corners: 0 top-left, 1 top-right, 2 bottom-left, 3 bottom-right
  std::vector<glm::ivec2> points;  ///< grid coordinates (x, y) of particles
  std::vector<int> vertices;       ///< for a mesh: vertex indices in the mesh's order
  std::optional<PinBox> box;       ///< pins the vertices of a mesh that are inside this box initially
  std::filesystem::path map;       ///< image over a mesh's uv that marks pinned vertices; empty if none
  bool clamp = false;  ///< for a fabric: true if the pinned border also keeps the direction in which the
                       ///< sheet leaves it
  int every = 1;       ///< pins every n-th particle of a row or column, and its last particle
  scene::Animated<glm::vec3> move = glm::vec3(0);    ///< translation in metres
  scene::Animated<glm::vec3> rotate = glm::vec3(0);  ///< rotation in degrees
  scene::Animated<glm::vec3> scale = glm::vec3(1);
  glm::vec3 pivot{0, 0, 0};  ///< centre of rotation and scale in world space, in metres
  std::string to;            ///< name of the body that carries the pins; empty if none
  std::string bone;
  PinPlace at = PinPlace::bone;
  [[nodiscard]] bool onSkin() const { return at == PinPlace::skin; }
  void describe(scene::Fields& fields, const glm::ivec2& grid, bool onMesh);

 private:
  void checkCarrier(scene::Fields& f) const;
  void checkTargets(scene::Fields& f, const glm::ivec2& grid, bool onMesh) const;
};

/// Air around the cloth.
struct Air : shader::AirConstants {
  std::string fluid;      ///< name of a fluid whose wind is added; empty if none
  float fluidSpeed = 10;  ///< expected maximum speed of the fluid in m/s
  scene::Animated<glm::vec3> velocity = glm::vec3(5, 0, 0);  ///< velocity in m/s
  float gusts = 0.3F;     ///< amplitude of the velocity's variation, as a fraction of the velocity's
                          ///< magnitude
  float gustSize = 0.8F;  ///< size of the gusts in metres
};

/// Contact of a cloth with itself and with other cloths.
struct ClothContact {
  std::optional<double> thickness;  ///< distance between two layers in metres
  float friction = 0.3F;            ///< Coulomb friction coefficient
};

enum class ClothSolver { springs, constraints };

/// Seam of a mesh: vertex i of `from` is sewn to vertex i of `to`.
struct Seam {
  std::vector<int> from, to;  ///< vertex indices in the mesh's order
  double seconds = 1;         ///< time in seconds after which the seam is closed
};

struct ClothParameters : ObjectParameters,
                         HasColorRange,
                         ShowsQuantity,
                         scene::HasFinish,
                         scene::HasOwnColors,
                         TouchesMeshes,
                         shader::ClothConstants {
  std::optional<ClothMesh> mesh;  ///< triangle mesh; empty if the cloth is a grid
  std::vector<Seam> seams;
  glm::ivec2 size{32, 32};      ///< number of particles along x and y
  glm::vec3 position{0, 0, 0};  ///< initial centre of the sheet in metres
  glm::vec3 rotation{0, 0, 0};  ///< rotation in degrees; without rotation the sheet lies in the xz plane
                                ///< with its rows along x
  float jitter = 0.0F;          ///< maximum random initial displacement in metres
  float mass = 1.0F;            ///< mass of a particle in kg
  ClothSolver solver = ClothSolver::springs;
  /// Fabric whose properties replace masses, springs and compliances. A mesh always has a fabric.
  std::optional<Fabric> fabric;
  float damping = 4.85F;  ///< rate in 1/s at which velocity decays
  scene::Animated<glm::vec3> gravity = glm::vec3(0, -9.8F, 0);
  scene::Animated<glm::vec3> wind = glm::vec3(0.5F, 0, 0.3F);  ///< constant force on each particle in
                                                               ///< newtons
  std::optional<Air> air;
  std::optional<int> substeps = 4;
  std::vector<PinGroup> pins;
  /// Radius plus margin, in multiples of the spacing, below which a collider is tested against edges and
  /// faces instead of vertices. Colliders that could pass between vertices (ColliderPlan::isThin()) are
  /// always tested so; this value adds larger ones, because the holes between the vertices of a stretched
  /// sheet are wider than the spacing.
  float smallColliders = 0;
  bool pinsByDefault = false;  ///< true if the scene gives no "pins"
  std::optional<ClothContact> contact;
  std::string walls;  ///< name of the solid whose walls the cloth collides with; empty if none
  ClothColoring coloring;

  ClothParameters();
  void describe(scene::Fields& fields) override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::vector<MeasuredRange> measuredRanges() override { return coloring.measuredRanges(); }
  [[nodiscard]] const char* coloredBy() const override {
    return coloring.used() ? "its \"colorBy\"" : nullptr;
  }
  [[nodiscard]] bool replacesTextures() const override { return coloring.used(); }
  [[nodiscard]] ShownQuantity shownQuantity() const override {
    using By = ClothColoring::By;
    if (coloring.by == By::speed) return {"speed", "m/s"};
    return {coloring.by == By::strain ? "strain" : ""};
  }
  [[nodiscard]] double touchMargin() const override {
    return margin + (fabric ? 0.5F * fabric->constants().thickness : 0);
  }
  /// Returns the bounds for the camera: the cloth in its initial position and where it will hang from the
  /// particles that are pinned initially. A cloth without pins is assumed to fall by its size.
  [[nodiscard]] std::optional<scene::Box> framed() const override;

  [[nodiscard]] std::int64_t minLargestBufferBytes() const override {
    return mesh ? 0 : std::int64_t{24} * (size.x - 1) * (size.y - 1);
  }
  [[nodiscard]] Looks looks() const override { return Looks::cloth; }
  [[nodiscard]] std::optional<scene::Material> look() const override;
  [[nodiscard]] bool motionIsUnpredictable() const override { return true; }
  /// Returns a copy of the parameters with `contactSubsteps` substeps per frame, a number that all cloths
  /// in contact have in common. If `contactSubsteps` is 0, the copy has the cloth's own number.
  [[nodiscard]] ClothParameters withContactSubsteps(int contactSubsteps) const;
  /// Returns the minimum number of substeps per frame for "auto": `otherwise`, but for a cloth in contact
  /// at least 960 per second. Contact is solved with only one or two rounds per substep, and 960 substeps
  /// per second keep layers apart.
  [[nodiscard]] int fewestSubsteps(double frameSeconds, int otherwise) const;
  /// Returns the distance in metres to keep between two layers of the cloth, given the distance `between`
  /// of neighbouring particles.
  [[nodiscard]] float contactThickness(float between) const;

  /// Returns true if XPBD constraints keep the lengths. Otherwise, springs apply forces.
  [[nodiscard]] bool constrained() const { return fabric || solver == ClothSolver::constraints; }
  /// Returns true if changes of length are damped.
  [[nodiscard]] bool damped() const { return fabric && fabric->stretchDamping > 0; }
  /// Returns true if the constraints keep energy (glsl/cloth/keeping.glsl), that is, without damping, air,
  /// contact and seams.
  [[nodiscard]] bool keepsEnergy() const {
    return constrained() && damping == 0 && !air && !damped() && !contact && seams.empty();
  }
  /// Returns the number of particles that hang from the most loaded pinned particle. Each particle hangs
  /// from the pinned particle that is nearest along rows and columns. Returns 0 if nothing is pinned or if
  /// the cloth is a mesh.
  [[nodiscard]] int maxOnOnePin() const;
  /// Returns the maximum squared angular frequency w^2 (1/s^2) of the sideways swings of the longest
  /// hanging line.
  [[nodiscard]] double hangingSquared() const;
  /// Returns the maximum squared angular frequency w^2 (1/s^2) of the sideways swings of a line at the most
  /// loaded pinned particle.
  [[nodiscard]] double pinnedSquared() const;
  /// Returns the mass of a particle in kg; for a fabric, this is the density times the part of the area
  /// that belongs to the particle.
  [[nodiscard]] float particleMass(glm::ivec2 at) const;
  /// Returns the index of the pin group that clamps a border (0 left, 1 right, 2 top, 3 bottom), or -1 if
  /// none does.
  [[nodiscard]] int clampOf(int border) const;
  /// Returns the maximum stable substep in seconds for a sheet near its rest shape in the fastest air and
  /// gusts of the whole run; with constraints, for a sheet that hangs from its pins.
  [[nodiscard]] double stableSeconds() const { return stableSeconds(1.0); }
  /// Returns the maximum stable substep in seconds if the air drag on a line is `lines` times the drag on
  /// the line's particles.
  [[nodiscard]] double stableSeconds(double lines) const;
  /// Returns the reason why the given number of substeps is too small and a remedy; empty if the number
  /// suffices or is "auto".
  [[nodiscard]] std::string instability(double frameSeconds) const;
  /// Returns the number of substeps per frame: the given number, or the number that "auto" computes. Throws
  /// UserError(usage) if it exceeds the maximum.
  [[nodiscard]] int substepsPerFrame(double frameSeconds) const;
  /// Returns the indices of the particles that a group pins, in ascending order, without duplicates.
  [[nodiscard]] std::vector<int> pinnedBy(const PinGroup& group) const;
  /// Returns the maximum acceleration in m/s^2 by gravity and wind in the whole run, for a particle with
  /// the mass `each` (kg).
  [[nodiscard]] double greatestLoad(double each) const;
  /// Returns the maximum air speed in the whole run in m/s; 0 if there is no air.
  [[nodiscard]] double fastestAir() const;

 private:
  void describeMesh(scene::Fields& fields);
  [[nodiscard]] std::optional<scene::Box> framedMesh() const;
  /// Returns true if the group pins a border (0 left, 1 right, 2 top, 3 bottom).
  [[nodiscard]] bool pinsBorder(const PinGroup& group, int border) const;
  [[nodiscard]] std::string steadierWay(double frameSeconds) const;
};

}  // namespace simreel::sim

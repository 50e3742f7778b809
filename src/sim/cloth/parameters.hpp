#pragma once
#include "scene/value/fields.hpp"
#include "sim/cloth/fabric.hpp"
#include "sim/cloth/mesh_source.hpp"
#include "sim/collide/mesh_colliders.hpp"
#include "sim/core/kind.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// What of a body carries pins.
enum class PinPlace { bone, skin };

/// Particles that do not move by themselves, and the moving frame they may be attached to.
struct PinGroup {
  std::vector<int> rows;  ///< negative counts from the end
  std::vector<int> columns;
  std::vector<int> corners;        ///< 0 top-left, 1 top-right, 2 bottom-left, 3 bottom-right
  std::vector<glm::ivec2> points;  ///< (x, y)
  std::vector<int> vertices;       ///< of a mesh, in its order
  bool hasBox = false;
  scene::Box box{glm::vec3(-1), glm::vec3(1)};  ///< m, world, of a mesh at rest
  std::filesystem::path map;                    ///< picture over a mesh's uv; empty: none
  bool clamp = false;  ///< borders keep the direction that the sheet leaves them in, a fabric's
  int every = 1;       ///< of a row or column only each n-th particle, the ends included
  scene::Animated<glm::vec3> move = glm::vec3(0);    ///< m
  scene::Animated<glm::vec3> rotate = glm::vec3(0);  ///< degrees
  scene::Animated<glm::vec3> scale = glm::vec3(1);
  glm::vec3 pivot{0, 0, 0};  ///< m, world; rotation and scale act about it
  std::string to;            ///< body whose bone carries them; empty: none
  std::string bone;
  PinPlace at = PinPlace::bone;
  [[nodiscard]] bool onSkin() const { return at == PinPlace::skin; }
  void describe(scene::Fields& fields, const glm::ivec2& grid, bool onMesh);
};

/// The air around the cloth.
struct Air : shader::AirConstants {
  std::string fluid;      ///< name of the fluid whose wind is added; empty: none
  float fluidSpeed = 10;  ///< m/s, greatest that is expected of it
  scene::Animated<glm::vec3> velocity = glm::vec3(5, 0, 0);  ///< m/s
  float gusts = 0.3F;     ///< size of the velocity's variation as a fraction of its magnitude
  float gustSize = 0.8F;  ///< m
};

/// How a cloth keeps off itself and others.
struct ClothContact {
  std::optional<double> thickness;  ///< m
  float friction = 0.3F;            ///< Coulomb's coefficient
};

enum class ClothSolver { springs, constraints };

/// Vertices of a mesh that are sewn together, the i-th of `from` to the i-th of `to`.
struct Seam {
  std::vector<int> from, to;  ///< in the mesh's order
  double seconds = 1;         ///< until it has pulled shut
};

struct ClothParameters : ObjectParameters, TouchesMeshes, shader::ClothConstants {
  bool hasMesh = false;  ///< instead of a grid
  ClothMesh mesh;
  std::vector<Seam> seams;
  glm::ivec2 size{32, 32};      ///< particles
  glm::vec3 position{0, 0, 0};  ///< m, middle of the sheet at rest
  glm::vec3 rotation{0, 0, 0};  ///< degrees; unrotated it lies in the xz plane, rows along x
  float jitter = 0.0F;          ///< m
  float mass = 1.0F;            ///< kg per particle
  ClothSolver solver = ClothSolver::springs;
  bool hasFabric = false;  ///< instead of masses, springs and constraints of its own
  Fabric fabric;
  float damping = 4.85F;  ///< 1/s
  scene::Animated<glm::vec3> gravity = glm::vec3(0, -9.8F, 0);
  scene::Animated<glm::vec3> wind = glm::vec3(0.5F, 0, 0.3F);  ///< N on each particle
  bool hasAir = false;
  Air air;
  std::optional<int> substeps = 4;
  std::vector<PinGroup> pins;
  bool pinsByDefault = false;  ///< whether a scene gives none
  bool hasContact = false;
  ClothContact contact;
  std::string walls;  ///< name of the solid it meets; empty: none

  ClothParameters();
  void describe(scene::Fields& fields) override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
  void ports(Ports& ports) const override;
  [[nodiscard]] double touchMargin() const override {
    return margin + (hasFabric ? 0.5F * fabric.constants().thickness : 0);
  }
  /// Where it is at rest, and where it comes to when it hangs from what is pinned at the start; without
  /// pins where it falls through once its size.
  [[nodiscard]] std::optional<scene::Box> framed() const override;

  [[nodiscard]] std::int64_t leastBlockBytes() const override {
    return hasMesh ? 0 : std::int64_t{24} * (size.x - 1) * (size.y - 1);
  }
  [[nodiscard]] Looks looks() const override { return Looks::cloth; }
  [[nodiscard]] bool wanders() const override { return true; }
  /// The same with as many substeps as what it touches takes; 0: its own.
  [[nodiscard]] ClothParameters inStep(int contactSubsteps) const;
  /// Fewest substeps of a frame that "auto" takes of cloth in contact: it is solved by a round or two in
  /// each, and at 960 a second layers keep apart.
  [[nodiscard]] int fewestSubsteps(double frameSeconds, int otherwise) const;
  /// m between two layers of it, on which the distance of neighbours is `between`.
  [[nodiscard]] float contactThickness(float between) const;

  /// Whether XPBD keeps the lengths; else springs are forces.
  [[nodiscard]] bool constrained() const { return hasFabric || solver == ClothSolver::constraints; }
  /// Whether changes of length are damped.
  [[nodiscard]] bool damped() const { return hasFabric && fabric.stretchDamping > 0; }
  /// Whether its constraints keep energy (glsl/cloth/keeping.glsl): where nothing damps, neither air nor
  /// contact, and nothing is sewn.
  [[nodiscard]] bool keepsEnergy() const {
    return constrained() && damping == 0 && !hasAir && !damped() && !hasContact && seams.empty();
  }
  /// Particles that hang on the pinned particle that carries most: each hangs on the nearest pinned one
  /// along rows and columns. 0: nothing is pinned, or it is a mesh.
  [[nodiscard]] int mostOnOnePin() const;
  /// 1/s^2: how fast the longest line that hangs swings sideways at most, w^2.
  [[nodiscard]] double hangingSquared() const;
  /// 1/s^2: how fast a line at the pinned particle that carries most does.
  [[nodiscard]] double pinnedSquared() const;
  /// kg of a particle: of a fabric, the density times its share of the area.
  [[nodiscard]] float massAt(glm::ivec2 at) const;
  /// The pin group that clamps the border left, right, top or bottom; -1: none.
  [[nodiscard]] int clampOf(int border) const;
  /// Longest stable substep in seconds, of the sheet near rest in the fastest air and gusts of the whole
  /// run; with constraints, of one that hangs by its pins.
  [[nodiscard]] double stableSeconds() const { return stableSeconds(1.0); }
  /// The same where a line carries so many times what the air pulls at its own particles.
  [[nodiscard]] double stableSeconds(double lines) const;
  /// Why the given substeps are too few and what to do; empty when they are enough or "auto".
  [[nodiscard]] std::string instability(double frameSeconds) const;
  /// Substeps a frame takes: the given number, or what "auto" comes to. Throws UserError(usage) when that
  /// is more than there may be.
  [[nodiscard]] int substepsPerFrame(double frameSeconds) const;
  /// Particle indices of a group, ascending, without repeats.
  [[nodiscard]] std::vector<int> pinnedBy(const PinGroup& group) const;
  /// m/s^2, greatest of gravity and wind in the whole run on a particle of that many kg.
  [[nodiscard]] double greatestLoad(double each) const;
  /// m/s, greatest of the air in the whole run; 0 without.
  [[nodiscard]] double fastestAir() const;

 private:
  void describeMesh(scene::Fields& fields);
  [[nodiscard]] std::optional<scene::Box> framedMesh() const;
  /// 0 left, 1 right, 2 top, 3 bottom.
  [[nodiscard]] bool pinsBorder(const PinGroup& group, int border) const;
  [[nodiscard]] std::string steadierWay(double frameSeconds) const;
};

}  // namespace simreel::sim

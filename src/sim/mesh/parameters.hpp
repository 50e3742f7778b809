#pragma once
#include "scene/outline.hpp"
#include "scene/tinted.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/mesh/deform_parameters.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <filesystem>
#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

enum class MeshShape { plane, sphere, torus, grass, file, box, cylinder, cone, disc };
enum class MeshSides { fitting, one, both };

/// Parameters of the object kind "mesh".
struct MeshParameters : ObjectParameters, scene::Outlined, scene::HasTint {
  MeshShape shape = MeshShape::plane;
  std::filesystem::path file;
  glm::vec3 size{4, 0, 4};         ///< width, height and depth in metres
  float radius = 1.0F;             ///< radius in metres
  float tube = 0.35F;              ///< radius of the tube of a torus in metres
  float height = 2.0F;             ///< height of a cylinder or cone in metres
  glm::ivec2 resolution{101, 65};  ///< number of vertices along u and v
  MeshSides sides = MeshSides::fitting;
  bool visible = true;
  int blades = 4000;          ///< number of blades of grass
  float bladeHeight = 0.5F;   ///< height of the tallest blades in metres
  float bladeWidth = 0.012F;  ///< width of a blade at its root in metres
  DeformParameters deform;
  scene::Animated<glm::vec3> position = glm::vec3(0);  ///< position in metres
  scene::Animated<glm::vec3> rotation = glm::vec3(0);  ///< rotation in degrees
  scene::Animated<float> scale = 1.0F;
  bool collides = false;           ///< true if the mesh collides: as a closed mesh, or as a height field if
                                   ///< it is deformed
  bool byFaces = false;            ///< true if the mesh's faces collide with cloths in contact
  float grip = 25.3F;              ///< decay rate (1/s) of the tangential velocity of objects that slide on
                                   ///< the mesh
  std::optional<double> friction;  ///< Coulomb friction coefficient, used instead of `grip`; if empty,
                                   ///< collisions of faces use the cloth's coefficient
  int distanceCells = 0;           ///< number of cells of the distance field along the longest side; 0
                                   ///< chooses it automatically
  void describe(scene::Fields& fields) override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
  [[nodiscard]] bool measures() const override { return !deform.list.empty(); }
  /// Returns the bounds of the undeformed mesh at all position keys together.
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  /// Returns the outline points of meshes from files; empty for other shapes.
  [[nodiscard]] std::vector<glm::vec3> outline() const override;
  /// Returns the default tint: green for grass.
  [[nodiscard]] std::optional<glm::vec3> tint() const override {
    return shape == MeshShape::grass ? std::optional(glm::vec3(0.11F, 0.24F, 0.045F)) : std::nullopt;
  }
  void ports(Ports& ports) const override;
  /// Returns true if the mesh collides as a rigid body, through its distance field.
  [[nodiscard]] bool collidesRigidly() const { return collides && deform.list.empty(); }

  [[nodiscard]] bool doubleSided() const;
  /// Returns the transform from the mesh's local space to world space at `time`.
  [[nodiscard]] glm::mat4 model(double time) const;
  /// Returns the time (seconds) of the last jump along the keyframes, at or before `time`.
  [[nodiscard]] double jumpedBy(double time) const;
  /// Generates or reads the mesh. Throws the errors of loadMesh().
  [[nodiscard]] Mesh make(int seed) const;

 protected:
  void describeCollision(scene::Fields& fields);
  /// Declares the fields for position, rotation, scale, sides and visibility.
  void describePlace(scene::Fields& fields);

 private:
  /// Returns the maximum vertical displacement in metres that the deformation causes.
  [[nodiscard]] float swell() const;
  /// Returns the positions of the undeformed vertices at every position key; empty if the file cannot be
  /// read.
  [[nodiscard]] std::vector<glm::vec3> placesAtRest() const;
  void remarkShape(scene::Fields& fields) const;
  void checkSolid(scene::Fields& fields) const;
  void checkHeights(scene::Fields& fields) const;
};

}  // namespace simreel::sim

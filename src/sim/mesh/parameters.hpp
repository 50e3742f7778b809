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

enum class MeshShape { plane, sphere, torus, grass, file };
enum class MeshSides { fitting, one, both };

/// Parameters of the kind mesh.
struct MeshParameters : ObjectParameters, scene::Outlined, scene::Tinted {
  MeshShape shape = MeshShape::plane;
  std::filesystem::path file;
  glm::vec3 size{4, 0, 4};         ///< m, of a plane
  float radius = 1.0F;             ///< m
  float tube = 0.35F;              ///< m
  glm::ivec2 resolution{101, 65};  ///< vertices along u and v
  MeshSides sides = MeshSides::fitting;
  bool visible = true;
  int blades = 4000;          ///< of grass
  float bladeHeight = 0.5F;   ///< m
  float bladeWidth = 0.012F;  ///< m
  DeformParameters deform;
  scene::Animated<glm::vec3> position = glm::vec3(0);  ///< m
  scene::Animated<glm::vec3> rotation = glm::vec3(0);  ///< degrees
  scene::Animated<float> scale = 1.0F;
  bool collides = false;           ///< as a closed mesh, or as a surface of heights
  bool byFaces = false;            ///< with cloths in contact
  float grip = 25.3F;              ///< 1/s
  std::optional<double> friction;  ///< Coulomb's coefficient, instead of `grip`; by faces none: the cloth's
  int distanceCells = 0;           ///< along its longest side; 0: by its size
  void describe(scene::Fields& fields) override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
  [[nodiscard]] bool measures() const override { return !deform.list.empty(); }
  /// As it is at rest, at each key of its position.
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  /// Of meshes of files.
  [[nodiscard]] std::vector<glm::vec3> outline() const override;
  /// Grass is green.
  [[nodiscard]] std::optional<glm::vec3> tint() const override {
    return shape == MeshShape::grass ? std::optional(glm::vec3(0.11F, 0.24F, 0.045F)) : std::nullopt;
  }
  void ports(Ports& ports) const override;
  /// Whether it collides as it is, by its distance field.
  [[nodiscard]] bool collidesRigidly() const { return collides && deform.list.empty(); }

  [[nodiscard]] bool doubleSided() const;
  /// From the mesh's own space to the world's at `time`.
  [[nodiscard]] glm::mat4 model(double time) const;
  /// When it last jumped there (s).
  [[nodiscard]] double jumpedBy(double time) const;
  /// Generates or reads the mesh. Throws what loadMesh throws.
  [[nodiscard]] Mesh make(int seed) const;

 private:
  /// m, by which what deforms it moves it up and down at most.
  [[nodiscard]] float swell() const;
  /// Its vertices at each key of its position; none where its file cannot be read.
  [[nodiscard]] std::vector<glm::vec3> placesAtRest() const;
  void remarkShape(scene::Fields& fields) const;
  void describeCollision(scene::Fields& fields);
  void checkSolid(scene::Fields& fields) const;
  void checkHeights(scene::Fields& fields) const;
};

}  // namespace simreel::sim

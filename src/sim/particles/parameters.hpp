#pragma once
#include "glsl/common/cpp.hpp"
#include "scene/value/fields.hpp"
#include "sim/collide/mesh_colliders.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/kind.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::shader {
#include "glsl/particles/types.glsl"
}

namespace simreel::sim {

/// A cloud of particles there from the start.
struct ParticleGroup {
  enum class Shape { ball, cube, plummer, disk, file };
  Shape shape = Shape::ball;
  int count = 1024;  ///< ignored for a file
  float radius =
      1.0F;  ///< m: of the ball, half the side of the cube, Plummer's scale a, the disk's scale length
  float thickness = 0.05F;     ///< disk: scale height as a fraction of radius
  float totalMass = 1.0F;      ///< kg, shared equally
  float centralMass = 0.0F;    ///< kg of one more particle in the middle (a disk's bulge); 0: none
  float speed = 0.0F;          ///< m/s, random, of ball and cube; plummer and disk start in equilibrium
  float spin = 0.0F;           ///< rad/s about the group's own y axis, of ball and cube
  glm::vec3 position{0};       ///< m, of the middle
  glm::vec3 velocity{0};       ///< m/s, of the whole
  glm::vec3 rotation{0};       ///< degrees, as elsewhere; disks lie in the xz plane
  std::filesystem::path file;  ///< CSV (x,y,z[,vx,vy,vz][,mass] named in the first line) or PLY
  void describe(scene::Fields& fields);
};

/// A source of particles that live for a while.
struct Emitter : shader::EmitterConstants {
  float rate = 1000.0F;                                      ///< 1/s
  scene::Animated<glm::vec3> position = glm::vec3(0);        ///< m
  scene::Animated<glm::vec3> velocity = glm::vec3(0, 3, 0);  ///< m/s
  float spread = 20.0F;                                      ///< degrees about the velocity
  float from = 0.0F, until = 1e9F;                           ///< s
  void describe(scene::Fields& fields);
};

/// Curl noise: a velocity field without sources.
struct Turbulence : shader::TurbulenceConstants {
  float size = 1.0F;   ///< m
  float speed = 0.3F;  ///< m/s at which the field drifts
};

enum class GravityMethod { none, allPairs, tree };  ///< "none", "all-pairs", "tree"

struct ParticleParameters : ObjectParameters, TouchesMeshes, shader::ParticleConstants {
  std::vector<ParticleGroup> groups;
  std::vector<Emitter> emitters;
  GravityMethod method = GravityMethod::allPairs;
  float gravity = 0.01F;   ///< G, m^3/(kg s^2)
  float softening = 0.1F;  ///< eps, m
  float opening = 0.5F;    ///< of "tree": the angle below which a cell counts as one body
  bool hasAttractor = false;
  scene::Animated<glm::vec3> attractorPosition = glm::vec3(0);  ///< m
  scene::Animated<float> attractorMass = 100.0F;                ///< kg
  scene::Animated<glm::vec3> acceleration = glm::vec3(0);       ///< m/s^2, the same everywhere
  Turbulence turbulence;
  int substeps = 1;
  bool collides = false;
  bool hasWind = false;
  std::string windFluid;       ///< name of the fluid that is their wind
  float windDrag = 4;          ///< 1/s
  std::string walls;           ///< name of the solid they meet; empty: none
  std::string cloths = "all";  ///< with contact, which they meet: "all", "none", or a name

  // How they look.
  Instances::Shape shape = Instances::Shape::sprite;
  std::filesystem::path mesh;
  bool alongVelocity = false;
  float size = 0.05F;
  float massExponent = 0.0F;
  Instances::ColorBy colorBy = Instances::ColorBy::material;
  glm::vec2 colorRange{0, 1};
  std::vector<glm::vec3> colors;  ///< linear stops
  bool additive = false;
  float brightness = 1.0F;
  float fade = 0.1F;

  void describe(scene::Fields& fields) override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] Looks looks() const override { return additive ? Looks::shining : Looks::solid; }
  [[nodiscard]] bool wanders() const override { return true; }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t leastBlockBytes() const override {
    std::int64_t bytes = 0;
    for (const ParticleGroup& group : groups)
      if (group.shape != ParticleGroup::Shape::file) bytes += std::int64_t{16} * group.count;
    return bytes;
  }
  [[nodiscard]] double touchMargin() const override { return collides ? margin : -1; }
  /// 1/s, at which they lose velocity: to rest and to the wind.
  [[nodiscard]] float slowing() const { return damping + (hasWind ? windDrag : 0.0F); }
  [[nodiscard]] bool meetsCloths() const { return collides && cloths != "none"; }
  /// The same with as many substeps as the cloths that it meets take; 0: its own.
  [[nodiscard]] ParticleParameters inStep(int contactSubsteps) const;

 private:
  void remarkForces(scene::Fields& fields) const;
  void describeLook(scene::Fields& fields);
};

}  // namespace simreel::sim

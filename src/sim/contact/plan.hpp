#pragma once
#include "sim/core/shader_code.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::shader {
#include "glsl/contact/types.glsl"
}

namespace simreel::sim {

/// Surface that touches other surfaces and itself.
struct ContactPart {
  std::vector<glm::vec4>
      positions;                  ///< Initial positions: xyz in metres, w inverse mass in 1/kg (0: held).
  std::vector<glm::uvec3> faces;  ///< Three indices into `positions` per face.
  float thickness =
      0.001F;  ///< Minimum distance in metres between the middle surfaces of two cloths of this thickness.
  float friction = 0.3F;  ///< Coulomb friction coefficient; -1 for a solid: the coefficient of the touching
                          ///< surface applies.
  std::vector<float> rooms;  ///< Maximum thickness per position in metres; empty: no limit.
  /// True for a solid: it follows its own motion and cloths give way. The cloth's thickness applies, and
  /// solids do not touch each other.
  bool solid = false;
  /// True for particles: no faces; w of `positions` is the mass in kg (0: dead). Particles keep the
  /// distance max(r, t / 2) + c / 2 from the middle surface of a cloth: r is their radius (`thickness`), t
  /// the thickness of the thickest cloth, c the thickness of this cloth.
  bool balls = false;
  float heaviest =
      0;  ///< For particles: mass in kg of the heaviest particle, including particles emitted later.
  float bounce = 0;        ///< For particles: fraction of the impact speed that is returned.
  std::string name = {};   ///< Name of a cloth, which particles can refer to.
  std::string meets = {};  ///< For particles: name of the cloth that they collide with; empty: all cloths.
};

/// Contact setup computed once on the CPU: the order of faces and edges in their bounding volume trees
/// (glsl/contact/search.glsl), and fixed-point units. Shared by the GPU and its CPU twin. The vertices of
/// all parts are numbered one part after the other. Each part is a subtree whose leaves are sorted by the
/// Morton order of their initial centres; the topology never changes, only the boxes are refitted. If there
/// are solids, they form the second half of each tree.
class ContactPlan {
 public:
  /// `parts`: cloths, then particles, then solids. Throws UserError(usage) if there are more faces than the
  /// kernels can index.
  ContactPlan(std::span<const ContactPart> parts, double substepSeconds);

  /// Leaves of the trees, a power of two each: the corners of a face, or the two ends of an edge with the
  /// second one repeated. w = 1 marks an empty leaf.
  [[nodiscard]] const std::vector<glm::uvec4>& faces() const { return faces_; }
  [[nodiscard]] const std::vector<glm::uvec4>& edges() const { return edges_; }
  /// Returns per vertex: x half the thickness in metres (for solids, half the thickness of the thickest
  /// cloth; for particles, the radius); y friction; z bounce; w the cloth's index, or for a particle the
  /// index of the cloth that it collides with, -1 for any.
  [[nodiscard]] const std::vector<glm::vec4>& skins() const { return skins_; }
  /// Returns the index of each part's first vertex.
  [[nodiscard]] const std::vector<int>& firsts() const { return firsts_; }
  [[nodiscard]] int vertices() const { return static_cast<int>(skins_.size()); }
  /// Returns the number of vertices of cloths and particles, which precede the solids.
  [[nodiscard]] int movable() const { return movable_; }
  /// Returns the index of the first particle.
  [[nodiscard]] int balls() const { return balls_; }
  /// carryRounds: number of cloth layers through which a moving solid's motion is propagated. rounds():
  /// number of impulse rounds, larger with solids, because a solid stops all of the cloth stretched over it
  /// at once.
  static constexpr int carryRounds = 4;
  [[nodiscard]] int rounds() const { return movable_ < vertices() ? 4 : 2; }
  [[nodiscard]] int faceLevels() const;
  [[nodiscard]] int edgeLevels() const;
  /// Returns the parameters of a substep. `first`: first substep of a frame, in which pairs are searched
  /// anew, so that a frame does not depend on earlier pairs.
  [[nodiscard]] shader::ContactStep step(bool first, int maxPairs) const;

 private:
  std::vector<glm::uvec4> faces_, edges_;
  std::vector<glm::vec4> skins_;
  std::vector<int> firsts_;
  int movable_ = 0;
  int balls_ = 0;
  double substepSeconds_;
  float quanta_ = 1.0F;
};

}  // namespace simreel::sim

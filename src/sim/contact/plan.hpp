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

/// Surface that collides with other surfaces and with itself.
struct ContactPart {
  std::vector<glm::vec4> positions;  ///< Initial positions: xyz in metres, w inverse mass in 1/kg (0 if
                                     ///< pinned).
  std::vector<glm::uvec3> faces;     ///< Three indices into `positions` per face.
  float thickness = 0.001F;  ///< Minimum distance in metres between the middle surfaces of two cloths with
                             ///< this thickness.
  float friction = 0.3F;     ///< Coulomb friction coefficient. A solid with -1 uses the coefficient of the
                             ///< cloth that touches it.
  std::vector<float> rooms;  ///< Maximum thickness in metres at each position; empty if there is no limit.
  /// True for a solid. A solid follows its prescribed motion, and cloths yield to it. The distance to a
  /// cloth is given by the cloth's thickness. Solids do not collide with each other.
  bool solid = false;
  /// True for particles. They have no faces; w of `positions` is the mass in kg (0 if dead). Particles keep
  /// the distance max(r, t / 2) + c / 2 from the middle surface of a cloth, where r is their radius
  /// (`thickness`), t the thickness of the thickest cloth, and c the thickness of the touched cloth.
  bool balls = false;
  float heaviest =
      0;             ///< For particles: maximum mass in kg of all particles, including those emitted later.
  float bounce = 0;  ///< For particles: fraction of the impact speed that remains after the bounce.
  std::string name = {};   ///< Name of a cloth, which particles can refer to.
  std::string meets = {};  ///< For particles: name of the cloth that they collide with; empty for all
                           ///< cloths.
};

/// Contact setup computed once on the CPU: the order of faces and edges in their bounding volume trees
/// (glsl/contact/search.glsl), and the fixed-point units. Used by the GPU simulation and by its CPU twin.
/// Vertices are numbered over all parts, one part after another. Each part is a subtree whose leaves are
/// sorted by the Morton order of their initial centres. The topology never changes; only the boxes are
/// recomputed. If there are solids, they form the second half of each tree.
class ContactPlan {
 public:
  /// `parts` holds cloths, then particles, then solids. Throws UserError(usage) if there are more faces
  /// than the kernels can index.
  ContactPlan(std::span<const ContactPart> parts, double substepSeconds);

  /// Return the leaves of a tree, whose number is a power of two. A leaf holds the three corners of a face,
  /// or the two ends of an edge with the second end repeated. w = 1 marks an empty leaf.
  [[nodiscard]] const std::vector<glm::uvec4>& faces() const { return faces_; }
  [[nodiscard]] const std::vector<glm::uvec4>& edges() const { return edges_; }
  /// Returns for each vertex: x half the thickness in metres (for solids, half the thickness of the
  /// thickest cloth; for particles, the radius); y friction coefficient; z bounce; w the cloth's index, or
  /// for a particle the index of the cloth that it collides with (-1 for any cloth).
  [[nodiscard]] const std::vector<glm::vec4>& skins() const { return skins_; }
  /// Returns the index of each part's first vertex.
  [[nodiscard]] const std::vector<int>& firsts() const { return firsts_; }
  [[nodiscard]] int vertices() const { return static_cast<int>(skins_.size()); }
  /// Returns the number of vertices of cloths and particles, whose indices precede the indices of the
  /// solids' vertices.
  [[nodiscard]] int movable() const { return movable_; }
  /// Returns the index of the first particle.
  [[nodiscard]] int balls() const { return balls_; }
  /// carryRounds is the number of cloth layers through which a moving solid's motion is propagated.
  /// rounds() is the number of impulse rounds. It is larger if there are solids, because a solid stops all
  /// parts of a cloth stretched over it at the same time.
  static constexpr int carryRounds = 4;
  [[nodiscard]] int rounds() const { return movable_ < vertices() ? 4 : 2; }
  [[nodiscard]] int faceLevels() const;
  [[nodiscard]] int edgeLevels() const;
  /// Returns the parameters of a substep. If `first` is true, it is the first substep of a frame; it
  /// searches for pairs again, so that a frame does not depend on earlier pairs.
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

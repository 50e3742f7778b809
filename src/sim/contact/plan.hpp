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

/// A surface that touches others and itself.
struct ContactPart {
  std::vector<glm::vec4> positions;  ///< first ones: xyz in m, w inverse mass in 1/kg (0: held)
  std::vector<glm::uvec3> faces;     ///< corners, numbers of its positions
  float thickness = 0.001F;          ///< m between its middle and that of another like it, at least
  float friction = 0.3F;             ///< Coulomb's coefficient; of a solid -1: that of who touches it
  std::vector<float> rooms;          ///< m, of each position the most for its thickness; empty: no limit
  /// It goes where it goes, and cloths give way: its thickness is theirs, and no two solids are a pair.
  bool solid = false;
  /// Particles: no faces, positions' w mass in kg (0: not alive). They keep `thickness`, their radius, and
  /// half a cloth's off the middle of cloths, but at least half of the thickest cloth's more than that.
  bool balls = false;
  float heaviest = 0;      ///< of balls: kg of the heaviest, of those that are born later, too
  float bounce = 0;        ///< of balls: the share of the speed of impact that is given back
  std::string name = {};   ///< of a cloth
  std::string meets = {};  ///< of balls: the name of the cloth that they meet; empty: all
};

/// What of contact is decided once, on the CPU: the order of faces and edges in their trees of boxes
/// (glsl/contact/search.glsl), units. Shared by the GPU and its CPU twin. Vertices of all parts are
/// numbered one part after the other.
///
/// Of a tree a part is a subtree of its own, in which what is near at the start is near in the tree
/// (Morton's order of middles); it stays as it is, only the boxes follow the cloth. Solids, where there are
/// any, are the second half of each tree.
class ContactPlan {
 public:
  /// `parts`: cloths, then balls, then solids. Throws UserError(usage) where there are more faces than the
  /// kernels can number.
  ContactPlan(std::span<const ContactPart> parts, double substepSeconds);

  /// Leaves of the trees, powers of two of them: corners of a face, or ends of an edge and the second one
  /// again; w 1: none.
  [[nodiscard]] const std::vector<glm::uvec4>& faces() const { return faces_; }
  [[nodiscard]] const std::vector<glm::uvec4>& edges() const { return edges_; }
  /// Of each vertex: x half the thickness (m), of solids that of the thickest cloth, of balls the radius; y
  /// friction; z bounce; w of a cloth its number, of a ball that of the cloth that it meets, -1 for any.
  [[nodiscard]] const std::vector<glm::vec4>& skins() const { return skins_; }
  /// First vertex of each part.
  [[nodiscard]] const std::vector<int>& firsts() const { return firsts_; }
  [[nodiscard]] int vertices() const { return static_cast<int>(skins_.size()); }
  /// Those of cloths and balls, which come first.
  [[nodiscard]] int movable() const { return movable_; }
  /// The first of balls.
  [[nodiscard]] int balls() const { return balls_; }
  /// Of impulses: a solid stops all of what is taut over it at once.
  /// Of cloth that solids carry carrying what lies in its way: so many layers.
  static constexpr int carryRounds = 4;
  [[nodiscard]] int rounds() const { return movable_ < vertices() ? 4 : 2; }
  [[nodiscard]] int faceLevels() const;
  [[nodiscard]] int edgeLevels() const;
  /// Of a substep; `first`: of a frame, where pairs are found anew so that frames depend on nothing else.
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

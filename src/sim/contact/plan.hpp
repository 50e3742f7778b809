#pragma once
#include "sim/core/shader_code.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
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
  float friction = 0.3F;             ///< Coulomb's coefficient
};

/// What of contact is decided once, on the CPU: who owns which vertex and edge, the order of faces in the
/// tree of boxes, units. Shared by the GPU and its CPU twin. Vertices of all parts are numbered one part
/// after the other.
///
/// The tree is binary and complete, node i over nodes 2 i and 2 i + 1, root 1, leaves from 2^levels on. A
/// part is a subtree of its own, in which faces that are near at the start are near each other (Morton's
/// order of their middles); it stays as it is, only the boxes follow the cloth.
class ContactPlan {
 public:
  /// Throws UserError(usage) where there are more faces than the kernels can number.
  ContactPlan(std::span<const ContactPart> parts, double substepSeconds);

  /// Of each leaf: corners of its face, and in w which of them (bits 0 to 2) and of its edges (bits 3 to 5,
  /// the k-th from the k-th corner on) it looks after; bit 31: it has no face.
  [[nodiscard]] const std::vector<glm::uvec4>& leaves() const { return leaves_; }
  /// Of each vertex: x half the thickness (m), y friction.
  [[nodiscard]] const std::vector<glm::vec2>& skins() const { return skins_; }
  /// First vertex of each part.
  [[nodiscard]] const std::vector<int>& firsts() const { return firsts_; }
  [[nodiscard]] int vertices() const { return static_cast<int>(skins_.size()); }
  [[nodiscard]] int faces() const { return faces_; }
  [[nodiscard]] int levels() const { return levels_; }
  /// Of a substep; `first`: of a frame, where pairs are found anew so that frames depend on nothing else.
  [[nodiscard]] shader::ContactStep step(bool first, int maxPairs) const;

 private:
  std::vector<glm::uvec4> leaves_;
  std::vector<glm::vec2> skins_;
  std::vector<int> firsts_;
  int faces_ = 0;
  int levels_ = 0;
  double substepSeconds_;
  float quanta_ = 1.0F;
};

}  // namespace simreel::sim

#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/contact/plan.hpp"
#include "sim/core/port.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

namespace simreel::sim {

/// A surface that cloths in contact feel by its faces, and that none of them moves. World steps its
/// simulation before them.
class ContactSolid {
 public:
  static const PortInfo port;

  virtual ~ContactSolid() = default;
  /// As it is at the start; waits for the device.
  [[nodiscard]] virtual ContactPart contactPart() const = 0;
  /// Makes now() and next() what they are at the beginning and the end of a substep of the frame that it
  /// has stepped, in any order.
  virtual void moveTo(int substep, int substeps) = 0;
  /// xyz m, in the order of contactPart().
  [[nodiscard]] virtual const gl::Vec4Array& now() const = 0;
  [[nodiscard]] virtual const gl::Vec4Array& next() const = 0;
};

/// What contact is told of a solid: vertices in m, three indices a face. Faces without area count for
/// nothing. Without `friction` that of who touches it holds.
[[nodiscard]] ContactPart solidPart(std::span<const glm::vec3> positions, std::span<const unsigned> indices,
                                    const std::optional<double>& friction);

struct MoveKernel;

/// Vertices of a mesh that is moved, deformed or both: over a frame each goes in a straight line.
class MovedVertices {
 public:
  /// `positions`: xyz m, in the mesh's own space.
  MovedVertices(const std::string& name, std::span<const glm::vec4> positions, bool fast);

  /// Where they are in their own space when a frame begins or ends; at first as they were made.
  void takeBegin(const gl::Vec4Array& positions) { take(positions, begins_); }
  void takeEnd(const gl::Vec4Array& positions) { take(positions, ends_); }
  /// From that space to the world, then.
  void place(const glm::mat4& begin, const glm::mat4& end);
  /// As ContactSolid has them.
  void moveTo(int substep, int substeps);
  [[nodiscard]] const gl::Vec4Array& now() const { return places_[0]; }
  [[nodiscard]] const gl::Vec4Array& next() const { return places_[1]; }

 private:
  static void take(const gl::Vec4Array& from, const gl::Vec4Array& to);
  void makeAt(double share, const gl::Vec4Array& places) const;

  int count_;
  gl::Vec4Array begins_, ends_, places_[2];
  int substep_ = -1;  ///< that places_ are of; -1: none
  int substeps_ = 0;
  glm::mat4 begin_{1}, end_{1};  ///< transposed
  gl::Kernel<MoveKernel> move_;
};

}  // namespace simreel::sim

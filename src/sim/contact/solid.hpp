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

/// Solid surface that collides with cloths in contact but is not moved by them. World steps its simulation
/// before the cloths.
class ContactSolid {
 public:
  static const PortInfo port;

  virtual ~ContactSolid() = default;
  /// Returns the contact surface in the initial state. Waits for the GPU.
  [[nodiscard]] virtual ContactPart contactPart() const = 0;
  /// Sets now() and next() to the positions at the start and the end of a substep. The solid must already
  /// have stepped the frame. Substeps may be requested in any order.
  virtual void moveTo(int substep, int substeps) = 0;
  /// Return positions in metres, in the order of contactPart().
  [[nodiscard]] virtual const gl::Vec4Array& now() const = 0;
  [[nodiscard]] virtual const gl::Vec4Array& next() const = 0;
};

/// Builds the contact part of a solid from vertices in metres and three indices per face. Degenerate faces
/// are ignored. If `friction` is empty, the coefficient of the touching cloth applies.
[[nodiscard]] ContactPart solidPart(std::span<const glm::vec3> positions, std::span<const unsigned> indices,
                                    const std::optional<double>& friction);

struct MoveKernel;

/// Vertices of a mesh that is moved, deformed, or both. Within a frame, each vertex moves in a straight
/// line.
class MovedVertices {
 public:
  /// `positions`: xyz in metres in the mesh's local space.
  MovedVertices(const std::string& name, std::span<const glm::vec4> positions, bool fast);

  /// Copies the local-space positions at the start or the end of the frame. Initially, both are the
  /// positions given to the constructor.
  void takeBegin(const gl::Vec4Array& positions) { copyPositions(positions, begins_); }
  void takeEnd(const gl::Vec4Array& positions) { copyPositions(positions, ends_); }
  /// Sets the local-to-world transforms at the start and the end of the frame.
  void place(const glm::mat4& begin, const glm::mat4& end);
  /// These functions behave like the functions of the same names in ContactSolid.
  void moveTo(int substep, int substeps);
  [[nodiscard]] const gl::Vec4Array& now() const { return places_[0]; }
  [[nodiscard]] const gl::Vec4Array& next() const { return places_[1]; }

 private:
  static void copyPositions(const gl::Vec4Array& from, const gl::Vec4Array& to);
  void makeAt(double share, const gl::Vec4Array& places) const;

  int count_;
  gl::Vec4Array begins_, ends_, places_[2];
  int substep_ = -1;  ///< Index of the substep whose positions are in `places_`; -1 if none exists.
  int substeps_ = 0;
  glm::mat4 begin_{1}, end_{1};  ///< Transposed local-to-world matrices at the start and the end of the
                                 ///< frame.
  gl::Kernel<MoveKernel> move_;
};

}  // namespace simreel::sim

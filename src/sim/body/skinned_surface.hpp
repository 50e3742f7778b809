#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/body/figure.hpp"
#include "sim/core/port.hpp"

#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

struct SkinKernel;

/// The skin of a body on the GPU at any moment of the present frame, in world space, for drawing and for
/// those that touch it. Between the poses of the frame's beginning and end the bones' matrices, and with
/// them each vertex, go in a straight line; the last substep's end is the frame's, to the bit.
///
/// Whoever touches it, in each of its n substeps i = 0 .. n-1, calls moveTo(i, n), then reads before(),
/// now() and faces() in a kernel, once the body has stepped (World does so first). Several may take turns:
/// each goes through a frame of its own.
class SkinnedSurface {
 public:
  static const PortInfo port;

  /// Throws UserError(device) for more vertices than one buffer holds; `name` stands in the message.
  SkinnedSurface(const std::string& name, const Figure& figure, bool fast);

  [[nodiscard]] int vertexCount() const { return vertexCount_; }
  /// Makes before() and now() what they are at the beginning and the end of a substep of `substeps`.
  void moveTo(int substep, int substeps);
  /// xyz m, w 1, a vertex an element.
  [[nodiscard]] const gl::Vec4Array& before() const { return touched_[0]; }
  [[nodiscard]] const gl::Vec4Array& now() const { return touched_[1]; }
  /// A face an element: its vertices in x, y and z, counter-clockwise seen from outside; w 0.
  [[nodiscard]] const gl::WordsArray& faces() const { return faces_; }

  /// The frame's poses, three rows a joint (BodyMotion::rowsAt), and the skin at its end: the body's own.
  void begin(std::vector<glm::vec4> atBegin, const std::vector<glm::vec4>& atEnd);
  /// Of the frame's end.
  [[nodiscard]] const gl::Vec4Array& positions() const { return positions_; }
  [[nodiscard]] const gl::Vec4Array& normals() const { return normals_; }

 private:
  void skin(const gl::Kernel<SkinKernel>& kernel, double now, const gl::Vec4Array& positions) const;

  std::string name_;
  int vertexCount_, joints_;
  gl::Vec4Array restPositions_, restNormals_, weights_, poses_;
  gl::WordsArray follow_, faces_;
  gl::Vec4Array positions_, normals_;
  gl::Vec4Array touched_[2];  ///< made when somebody first asks
  int substep_ = -1;          ///< that touched_ is of; -1: none
  int substeps_ = 0;
  gl::Kernel<SkinKernel> draw_, move_;
};

}  // namespace simreel::sim

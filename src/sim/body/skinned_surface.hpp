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

/// Skin of a body on the GPU at any time within the current frame, in world space, for drawing and for
/// collisions. Within a frame, the bones' matrices, and hence the vertices, are interpolated linearly. The
/// end of the last substep equals the end of the frame bit for bit.
///
/// An object that collides with the skin calls moveTo(i, n) in each of its n substeps i = 0 .. n-1 and then
/// reads before(), now() and faces() in a kernel. The body must already have stepped; World ensures that.
/// Several objects may use the surface one after another, each with a different n.
class SkinnedSurface {
 public:
  static const PortInfo port;

  /// Throws UserError(device) if the vertices or faces exceed one buffer; `name` appears in the message.
  SkinnedSurface(const std::string& name, const Figure& figure, bool fast);

  [[nodiscard]] int vertexCount() const { return vertexCount_; }
  /// Sets before() and now() to the positions at the beginning and the end of a substep. A frame has
  /// `substeps` substeps.
  void moveTo(int substep, int substeps);
  /// Return one element per vertex: xyz is the position in metres, w = 1.
  [[nodiscard]] const gl::Vec4Array& before() const { return touched_[0]; }
  [[nodiscard]] const gl::Vec4Array& now() const { return touched_[1]; }
  /// Returns one element per face: vertex indices in x, y and z, counter-clockwise as seen from outside; w
  /// = 0.
  [[nodiscard]] const gl::WordsArray& faces() const { return faces_; }

  /// Sets the poses at the beginning and the end of the frame, three matrix rows per joint
  /// (BodyMotion::rowsAt), and computes the skin at the end. Only the body itself may call it.
  void begin(std::vector<glm::vec4> atBegin, const std::vector<glm::vec4>& atEnd);
  /// Return the positions and the normals at the end of the frame.
  [[nodiscard]] const gl::Vec4Array& positions() const { return positions_; }
  [[nodiscard]] const gl::Vec4Array& normals() const { return normals_; }

 private:
  void skin(const gl::Kernel<SkinKernel>& kernel, double now, const gl::Vec4Array& positions) const;

  std::string name_;
  int vertexCount_, joints_;
  gl::Vec4Array restPositions_, restNormals_, weights_, poses_;
  gl::WordsArray follow_, faces_;
  gl::Vec4Array positions_, normals_;
  gl::Vec4Array touched_[2];  ///< buffers of before() and now(), allocated on first use
  int substep_ = -1;          ///< index of the substep whose positions are in touched_; -1 if none exists
  int substeps_ = 0;
  gl::Kernel<SkinKernel> draw_, move_;
};

}  // namespace simreel::sim

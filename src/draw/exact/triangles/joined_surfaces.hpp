#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// True if this device joins surfaces and draws all lamp maps in one dispatch. The environment variable
/// SIMREEL_JOIN_SURFACES ("yes" or "no") overrides the default. Throws UserError(usage) for another value.
[[nodiscard]] bool joinsSurfaces();

struct JoinKernel;

/// Joins all surfaces of a picture into one mesh in world space, with triangles in the order of their ids.
/// A dispatch takes some microseconds on GPUs, and each separate surface needs five dispatches. The picture
/// is the same.
class JoinedSurfaces {
 public:
  /// Joins the surfaces and returns true. Returns false if there are few surfaces or if the GPU determines
  /// a triangle count.
  bool join(const std::vector<sim::Surface>& surfaces);
  /// Returns the joined surface. It casts shadows if its parts do; join() requires that all parts or none
  /// cast shadows.
  [[nodiscard]] const sim::Surface& surface() const { return surface_; }
  /// Returns, for each triangle, the index of its surface and a flag for double-sided surfaces.
  [[nodiscard]] const gl::Texture& owners() const { return ownerView_; }
  /// Returns the materials of the surfaces.
  [[nodiscard]] const gl::Texture& looks() const { return lookView_; }

 private:
  /// State of a surface in the GPU buffers.
  struct Part {
    unsigned still = 0;
    glm::mat4 model{1.0F};
    bool doubleSided = false;
    int firstVertex = 0, firstTriangle = 0;
    bool operator==(const Part&) const = default;
  };
  static bool suits(const std::vector<sim::Surface>& surfaces);
  void makeRoom(std::size_t vertices, std::size_t triangles, std::size_t surfaces);
  void put(const sim::Surface& surface, const Part& part, int number);
  void tellLooks(const std::vector<sim::Surface>& surfaces);

  gl::Kernels<JoinKernel> kernels_;
  std::vector<Part> parts_;
  std::vector<glm::vec4> looks_;
  gl::Buffer places_, normals_, indices_, owners_, lookBuffer_;
  gl::Texture placeView_, normalView_, ownerView_, lookView_;
  sim::Surface surface_;
};

}  // namespace simreel::draw

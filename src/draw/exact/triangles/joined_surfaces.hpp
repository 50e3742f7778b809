#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// Whether surfaces are joined on this device, and all maps of lamps drawn in one go, or as
/// SIMREEL_JOIN_SURFACES says, "yes" or "no". Throws UserError(usage) for another word.
[[nodiscard]] bool joinsSurfaces();

struct JoinKernel;

/// All surfaces of a picture as one in world space, their triangles in the order that their numbers have:
/// cards take some microseconds for each dispatch, whatever its size, and else there are five a surface.
/// The picture is the same.
class JoinedSurfaces {
 public:
  /// Few surfaces, and those whose triangles the GPU counts, stay apart: false.
  bool join(const std::vector<sim::Surface>& surfaces);
  /// As join() has made it. It casts shadows if they do, all or none.
  [[nodiscard]] const sim::Surface& surface() const { return surface_; }
  /// Of each triangle whose it is and which sides it shows.
  [[nodiscard]] const gl::Texture& owners() const { return ownerView_; }
  /// What surfaces are made of.
  [[nodiscard]] const gl::Texture& looks() const { return lookView_; }

 private:
  /// What the GPU holds of a surface.
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

#pragma once
#include "draw/exact/instances/copy_raster.hpp"
#include "draw/exact/rays/hierarchy.hpp"
#include "draw/instances/instance_values.hpp"
#include "sim/core/drawable.hpp"

#include <map>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::draw {

/// What rays meet of a picture's scene: triangles of all surfaces and of copies of meshes, balls, and the
/// ground. What adds light is not among it.
class RayScene {
 public:
  explicit RayScene(bool ground)
      : ground_(ground), bounds_("bounds of what rays meet", 8 * sizeof(GLuint)) {}
  /// The frame's uniform block is bound. Throws UserError(device) where there is more than the device
  /// holds.
  void build(const sim::Drawables& drawables);
  /// Traces rays `first` to before `first + count` of a buffer; `hits` as large. `any`: whether light gets
  /// through.
  void trace(const gl::Texture& rays, const gl::Buffer& hits, int first, int count, bool any);
  /// What kernels need that find out what has been met.
  [[nodiscard]] gl::Defines defines() const;
  void bind(const gl::Program& program) const;
  /// A bit each: triangles, balls, ground.
  [[nodiscard]] unsigned features() const {
    return (triangles_.count() > 0 ? 1U : 0U) | (balls_.count() > 0 ? 2U : 0U) | (ground_ ? 4U : 0U);
  }

 private:
  void count(const sim::Drawables& drawables);
  void gatherSurface(const sim::Surface& surface, int firstVertex, int firstTriangle, unsigned owner);
  void gatherCopies(const CopyRaster::Copies& copies, InstanceColors& colors, int firstVertex,
                    int firstTriangle, unsigned owner);
  void gatherBalls(const sim::Instances& balls, InstanceColors& colors, int firstBall, unsigned owner);
  [[nodiscard]] CopyRaster::Copies copiesOf(const sim::Instances& instances) {
    return {&instances, &shapes_.of(instances)};
  }

  bool ground_;
  InstanceShapes shapes_{false};
  std::vector<InstanceColors> colors_;
  CopyRaster copyRaster_{CopyRaster::Into::picture, 1};
  Hierarchy triangles_{Hierarchy::Of::triangles}, balls_{Hierarchy::Of::balls};
  std::map<unsigned, gl::Program> gatherPrograms_, tracePrograms_;
  gl::Program copyProgram_, ballProgram_;
  gl::Buffer bounds_, places_, words_, corners_, lookBuffer_, ballPlaces_, ballLookBuffer_;
  gl::Texture placeView_, wordView_, cornerView_, lookView_, ballPlaceView_, ballLookView_;
  int triangleCount_ = 0, vertexCount_ = 0, ballCount_ = 0;
};

}  // namespace simreel::draw

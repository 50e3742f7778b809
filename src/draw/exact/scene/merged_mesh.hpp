#pragma once
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <map>
#include <utility>
#include <vector>

namespace simreel::draw {

/// Surfaces as one in world space, for what draws them many times: a dispatch for each of many small ones
/// costs software drivers more than their triangles.
class MergedMesh {
 public:
  MergedMesh();
  /// Holds until the next call: triangles in any order, without normals. The deformations' blocks need not
  /// be bound.
  const sim::Surface& merge(const std::vector<const sim::Surface*>& surfaces);

 private:
  const gl::Program& program(bool deformed, bool counted);

  std::map<std::pair<bool, bool>, gl::Program> programs_;
  gl::Buffer places_, indices_, count_;
  gl::Texture placesView_;
  scene::Material material_;
  sim::Surface all_;
};

}  // namespace simreel::draw

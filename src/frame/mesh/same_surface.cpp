#include "frame/mesh/same_surface.hpp"

#include "base/error.hpp"

#include <algorithm>

namespace simreel::frame {

namespace {

/// Returns a description of how the topology or uvs of `mesh` differ from the first frame. Returns an empty
/// text if they are equal.
std::string difference(const sim::MeshTable& mesh, const sim::MeshTable& first) {
  if (mesh.indices.size() != first.indices.size())
    return fmt::format("{} triangles instead of {}", mesh.indices.size() / 3, first.indices.size() / 3);
  if (mesh.positions.size() != first.positions.size())
    return fmt::format("{} vertices instead of {}", mesh.positions.size(), first.positions.size());
  if (mesh.indices != first.indices) return "other triangles";
  return mesh.uvs != first.uvs ? "other texture coordinates" : "";
}

}  // namespace

sim::MeshTable SameSurface::next(const sim::MeshTable& mesh) {
  const int frame = plan_.frames.at(seen_++);
  if (!named_) {
    if (mesh.indices.empty())
      fail(ExitCode::usage, "\"{}\" has no triangles in frame {}: there is no surface to bake", plan_.name,
           frame);
    first_ = mesh;
    first_.normals.clear();
    named_.emplace(mesh);
  } else if (const std::string what = difference(mesh, first_); !what.empty()) {
    fail(ExitCode::usage,
         "\"{}\" has {} in frame {}, but one file holds one surface that moves; bake a file a frame, "
         "without --sequence, pc2 or mdd",
         plan_.name, what, frame);
  }
  return named_->of(mesh);
}

}  // namespace simreel::frame

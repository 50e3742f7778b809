#pragma once
#include "frame/mesh/mesh_sequence.hpp"
#include "frame/mesh/named_vertices.hpp"

#include <optional>

namespace simreel::frame {

/// Checks that all frames of a sequence have the triangles and uvs of the first frame.
class SameSurface {
 public:
  explicit SameSurface(const SequencePlan& plan) : plan_(plan) {}

  /// Returns the mesh of the next frame without unused vertices. Throws UserError(usage) if the triangles
  /// or uvs differ from the first frame.
  [[nodiscard]] sim::MeshTable next(const sim::MeshTable& mesh);
  /// Returns the number of frames passed to next().
  [[nodiscard]] std::size_t seen() const { return seen_; }

 private:
  const SequencePlan& plan_;
  std::size_t seen_ = 0;
  sim::MeshTable first_;  ///< mesh of the first frame, without normals
  std::optional<NamedVertices> named_;
};

}  // namespace simreel::frame

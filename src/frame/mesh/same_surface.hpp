#pragma once
#include "frame/mesh/mesh_sequence.hpp"
#include "frame/mesh/named_vertices.hpp"

#include <optional>

namespace simreel::frame {

/// Holds the frames of a sequence to the triangles and uvs of the first.
class SameSurface {
 public:
  explicit SameSurface(const SequencePlan& plan) : plan_(plan) {}

  /// The next frame, with the vertices that its triangles name only. Throws UserError(usage).
  [[nodiscard]] sim::MeshTable next(const sim::MeshTable& mesh);
  /// Frames that it has seen.
  [[nodiscard]] std::size_t seen() const { return seen_; }

 private:
  const SequencePlan& plan_;
  std::size_t seen_ = 0;
  sim::MeshTable first_;  ///< without normals
  std::optional<NamedVertices> named_;
};

}  // namespace simreel::frame

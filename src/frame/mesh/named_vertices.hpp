#pragma once
#include "sim/core/simulation.hpp"

#include <vector>

namespace simreel::frame {

/// Selects the vertices of a mesh that its triangles use, in their original order. Unused vertices are
/// dropped, because importers number vertices differently if a format contains unused ones.
class NamedVertices {
 public:
  explicit NamedVertices(const sim::MeshTable& mesh);

  /// Returns `mesh` without unused vertices. `mesh` must have the same triangles as the mesh of the
  /// constructor.
  [[nodiscard]] sim::MeshTable of(const sim::MeshTable& mesh) const;
  /// Returns the rows of the used vertices. `rows` has one row per vertex of the mesh, or is empty.
  template <class Row>
  [[nodiscard]] std::vector<Row> of(const std::vector<Row>& rows) const {
    std::vector<Row> named;
    if (rows.empty()) return named;
    named.reserve(kept_.size());
    for (const unsigned i : kept_) named.push_back(rows[i]);
    return named;
  }

 private:
  std::vector<unsigned> kept_;   ///< indices of the used vertices
  std::vector<unsigned> place_;  ///< new index of each used vertex, indexed by its old index
};

}  // namespace simreel::frame

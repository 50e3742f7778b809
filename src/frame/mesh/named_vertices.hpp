#pragma once
#include "sim/core/simulation.hpp"

#include <vector>

namespace simreel::frame {

/// The vertices of a mesh that its triangles name, in their order; formats that hold nothing else would
/// count others differently from one program to the next.
class NamedVertices {
 public:
  explicit NamedVertices(const sim::MeshTable& mesh);

  /// That mesh, or one of the same triangles, without the others.
  [[nodiscard]] sim::MeshTable of(const sim::MeshTable& mesh) const;

 private:
  std::vector<unsigned> kept_;   ///< their numbers
  std::vector<unsigned> place_;  ///< of each vertex among them
};

}  // namespace simreel::frame

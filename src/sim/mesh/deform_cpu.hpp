#pragma once
#include "sim/mesh/deform_plan.hpp"
#include "sim/mesh/deform_rest.hpp"

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

enum class Threads { one, all };

/// Deforms a mesh on the CPU with the same code as the shaders (glsl/mesh compiled as C++), so that in
/// exact mode every word equals the GPU's result. Serves as the reference in tests and runs the CPU
/// techniques. The threads process batches of 64 vertices.
class DeformCpu {
 public:
  /// Keeps a reference to `rest`, which must outlive this object.
  DeformCpu(const RestMesh& rest, glm::ivec2 trailCells);

  /// Presses the colliders of `step` into the footprint trail.
  void press(const shader::DeformStep& step, Threads threads);
  /// Computes the deformed positions from the rest mesh. Also writes them to `also` unless it is empty.
  void displace(const shader::DeformStep& step, Threads threads, std::span<glm::vec4> also = {});
  /// Computes normals from the deformed positions. Also writes them to `also` unless it is empty.
  void gatherNormals(Threads threads, std::span<glm::vec4> also = {});

  [[nodiscard]] const std::vector<glm::vec4>& positions() const {
    return positions_;
  }  ///< deformed positions: xyz
     ///< in metres, w = 1
  [[nodiscard]] const std::vector<glm::vec4>& normals() const {
    return normals_;
  }  ///< unit normals: xyz, w = 0
  [[nodiscard]] const std::vector<glm::vec4>& trail() const {
    return trail_;
  }  ///< footprint trail: x is the
     ///< depth, y the rim height,
     ///< in metres
  /// Replaces the trail by the trail computed on the GPU; its elements are ordered with x fastest.
  void setTrail(std::vector<glm::vec4> trail) { trail_ = std::move(trail); }

 private:
  const RestMesh& rest_;
  std::vector<glm::vec4> positions_, normals_, trail_;
};

}  // namespace simreel::sim

#pragma once
#include "sim/mesh/deform_plan.hpp"
#include "sim/mesh/deform_rest.hpp"

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

enum class Threads { one, all };

/// Deforms on the CPU: the shaders' own model (glsl/mesh compiled as C++), so that in exact numerics
/// every word equals the device's. It is the twin that tests compare the device with, and what the CPU
/// techniques run. Threads take 64 vertices at a time.
class DeformCpu {
 public:
  /// `rest` must outlive this.
  DeformCpu(const RestMesh& rest, glm::ivec2 trailCells);

  /// Presses the colliders of `step` into the trail.
  void press(const shader::DeformStep& step, Threads threads);
  /// Positions from rest. A copy goes to `also`, unless that is empty.
  void displace(const shader::DeformStep& step, Threads threads, std::span<glm::vec4> also = {});
  /// Normals from positions. A copy goes to `also`, unless that is empty.
  void gatherNormals(Threads threads, std::span<glm::vec4> also = {});

  [[nodiscard]] const std::vector<glm::vec4>& positions() const { return positions_; }  ///< xyz m, w 1
  [[nodiscard]] const std::vector<glm::vec4>& normals() const { return normals_; }      ///< xyz unit, w 0
  [[nodiscard]] const std::vector<glm::vec4>& trail() const { return trail_; }  ///< x print, y rim (m)
  /// Takes the device's trail, x fastest.
  void setTrail(std::vector<glm::vec4> trail) { trail_ = std::move(trail); }

 private:
  const RestMesh& rest_;
  std::vector<glm::vec4> positions_, normals_, trail_;
};

}  // namespace simreel::sim

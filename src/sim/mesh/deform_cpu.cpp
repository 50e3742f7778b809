#include "sim/mesh/deform_cpu.hpp"

#include "sim/core/shader_code.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace simreel::sim {

namespace {

using namespace shader;  // NOLINT: the included model uses GLSL's type names

#define FUNCTION inline
#define precise
/// Provides the inputs that the model code of displace.comp and press.comp reads.
struct Model {
  const DeformStep& deformStep;
  const vec4* trail;

  [[nodiscard]] vec4 loadTrail(int i) const { return trail[i]; }
#include "glsl/mesh/model.glsl"
};

/// Provides the inputs that the model code of normal.comp reads.
struct NormalModel {
  const RestMesh& rest;
  const vec4* positions;

  [[nodiscard]] vec3 loadDisplaced(int i) const { return vec3(positions[i]); }
  [[nodiscard]] uvec4 loadFan(int i) const { return rest.fans[static_cast<std::size_t>(i)]; }
  [[nodiscard]] uvec4 loadFaces(int i) const { return rest.faces[static_cast<std::size_t>(i)]; }
#include "glsl/mesh/normal.glsl"
};
#undef precise
#undef FUNCTION

template <class Body>
void forEach(std::size_t count, Threads threads, const Body& body) {
  constexpr std::size_t batch = 64;
  if (threads == Threads::one) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, batch),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
      },
      tbb::simple_partitioner());
}

}  // namespace

DeformCpu::DeformCpu(const RestMesh& rest, glm::ivec2 trailCells)
    : rest_(rest),
      positions_(rest.positions.size()),
      normals_(rest.positions.size()),
      trail_(static_cast<std::size_t>(trailCells.x) * static_cast<std::size_t>(trailCells.y), vec4(0)) {}

void DeformCpu::press(const DeformStep& step, Threads threads) {
  const int width = step.trail.cells.x;
  forEach(trail_.size(), threads, [&](std::size_t i) {
    Model model{step, trail_.data()};
    const int cell = static_cast<int>(i);
    trail_[i] = model.trodden({cell % width, cell / width}, trail_[i]);
  });
}

void DeformCpu::displace(const DeformStep& step, Threads threads, std::span<vec4> also) {
  forEach(positions_.size(), threads, [&](std::size_t i) {
    Model model{step, trail_.data()};
    const vec4 position(model.displaced(vec3(rest_.positions[i])), 1.0F);
    positions_[i] = position;
    if (!also.empty()) also[i] = position;
  });
}

void DeformCpu::gatherNormals(Threads threads, std::span<vec4> also) {
  forEach(normals_.size(), threads, [&](std::size_t i) {
    NormalModel model{rest_, positions_.data()};
    const vec4 normal(model.gatheredNormal(static_cast<int>(i), vec3(rest_.normals[i])), 0.0F);
    normals_[i] = normal;
    if (!also.empty()) also[i] = normal;
  });
}

}  // namespace simreel::sim

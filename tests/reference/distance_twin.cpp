#include "reference/distance_twin.hpp"

#include "sim/core/shader_code.hpp"
#include "sim/particles/parameters.hpp"

#include <utility>

namespace {

using namespace simreel::shader;

#define FUNCTION inline
#define precise
#include "glsl/collide/distance/bindings.glsl"
/// Provides the tree access that the kernels' model needs, and includes the model file.
struct DistanceKernel {
  const simreel::sim::DistancePlan& plan;
  int firstLeaf;
  [[nodiscard]] vec4 loadBox(int i) const { return plan.boxes[static_cast<std::size_t>(i)]; }
  [[nodiscard]] vec4 loadFace(int i) const { return plan.faces[static_cast<std::size_t>(i)]; }
#include "glsl/collide/distance/model.glsl"
};
struct FieldKernel {
  ParticleStep stepData{};
  MeshColliders meshData{};
  const uvec4* fieldCells = nullptr;
  [[nodiscard]] uvec4 loadFieldCell(int i) const { return fieldCells[i]; }
#include "glsl/collide/model.glsl"
};
#undef precise
#undef FUNCTION

}  // namespace

glm::vec4 distanceTwinAt(const DistanceTwin& twin, const glm::vec3& place) {
  FieldKernel kernel;
  kernel.meshData = twin.plan.frame(0, 1, 1).front();
  kernel.fieldCells = twin.cells.data();
  const FieldKernel::FieldPoint p = kernel.fieldAt(0, place);
  return {p.slope, p.there ? p.distance_ : 1e9F};
}

float distanceTo(const simreel::sim::DistancePlan& plan, const glm::vec3& place) {
  DistanceKernel kernel{plan, plan.firstLeaf};
  DistanceKernel::Search search = kernel.begun(place);
  while (search.box != 0) search = kernel.searched(place, search);
  return kernel.signedDistance(place, search.face);
}

DistanceTwin::DistanceTwin(simreel::sim::MeshColliderPlan from) : plan(std::move(from)) {
  for (const auto& part : plan.parts()) {
    const simreel::sim::DistancePlan& p = part.plan;
    DistanceKernel kernel{p, p.firstLeaf};
    const ivec3 nodes = p.cells + 1;
    std::vector<int> values;
    for (int z = 0; z < nodes.z; ++z)
      for (int y = 0; y < nodes.y; ++y)
        for (int x = 0; x < nodes.x; ++x) {
          const vec3 place = vec3(x, y, z) * p.cell + p.corner;
          values.push_back(kernel.wholeUnits(distanceTo(p, place), 1.0F / p.unit));
        }
    const auto pairAt = [&](int x, int y, int z) {
      const auto i = static_cast<std::size_t>((z * nodes.y + y) * nodes.x + x);
      return kernel.halves(values[i], values[i + 1]);
    };
    for (int z = 0; z < p.cells.z; ++z)
      for (int y = 0; y < p.cells.y; ++y)
        for (int x = 0; x < p.cells.x; ++x)
          cells.emplace_back(pairAt(x, y, z), pairAt(x, y + 1, z), pairAt(x, y, z + 1),
                             pairAt(x, y + 1, z + 1));
  }
}

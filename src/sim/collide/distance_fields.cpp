#include "sim/collide/distance_fields.hpp"

#include "base/error.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace simreel::sim {

namespace {

/// Part of a kernel interface: inputs common to the kernels (glsl/collide/distance/kernel.glsl).
struct DistancePart {
  gl::Uniform<"nodes", glm::ivec4> nodes;
  gl::Uniform<"corner", glm::vec4> corner;
  gl::Uniform<"perUnit", float> perUnit;
  gl::Uniform<"firstLeaf", int> firstLeaf;
  gl::In<"boxes"> boxes;
  gl::In<"faces"> faces;
  gl::InOut<"searches"> searches;
};

struct DistanceMeasure {
  static constexpr auto file = "collide/distance/measure.comp";
  DistancePart part;
  gl::Uniform<"rounds", int> rounds;
  gl::Uniform<"begins", bool> begins;
  gl::InOut<"LeftBlock"> left;
};

struct DistanceSign {
  static constexpr auto file = "collide/distance/sign.comp";
  DistancePart part;
};

struct DistancePack {
  static constexpr auto file = "collide/distance/pack.comp";
  DistancePart part;
  gl::Uniform<"firstCell", int> firstCell;
  gl::Out<"cells"> cells;
};

constexpr int roundsOfSearch = 4096;  // number of search iterations per dispatch; each iteration runs an
                                      // inner loop of up to leafFaces iterations

void checkSize(const char* what, std::size_t elements, const char* advice) {
  const std::int64_t maximum =
      std::min(gl::limits().storageBlockBytes / 16, gl::limits().texelBufferTexels);
  if (static_cast<std::int64_t>(elements) > maximum)
    fail(ExitCode::device,
         "the {} of the meshes that collide are {} elements of 16 bytes, this device allows {} in one "
         "buffer; {}",
         what, elements, maximum, advice);
}

}  // namespace

constinit const PortInfo DistanceFields::port = {
    .name = "distance fields", .lacks = ", which is no rigid mesh", .none = "the scene has no rigid mesh"};

DistanceFields::DistanceFields(MeshColliderPlan plan) : plan_(std::move(plan)) {
  checkSize("cells", static_cast<std::size_t>(plan_.cellCount()), "lower \"distanceCells\"");
  cells_ = gl::WordsArray("distance fields", plan_.cellCount());
  for (const MeshColliderPlan::Part& part : plan_.parts()) make(part);
}

void DistanceFields::make(const MeshColliderPlan::Part& mesh) {
  const DistancePlan& plan = mesh.plan;
  checkSize("faces", plan.faces.size(), "take a coarser mesh");
  checkSize("nodes", static_cast<std::size_t>(plan.nodeCount()), "lower \"distanceCells\"");
  const gl::Vec4Array boxes(mesh.name + " boxes", plan.boxes);
  const gl::Vec4Array faces(mesh.name + " faces", plan.faces);
  gl::WordsArray nodes(mesh.name + " distances", plan.nodeCount());
  const unsigned none[4] = {};
  gl::Buffer left = gl::Buffer::of<unsigned>(mesh.name + " left", none);
  const DistancePart part = {.nodes = glm::ivec4(plan.cells + 1, plan.nodeCount()),
                             .corner = glm::vec4(plan.corner, plan.cell),
                             .perUnit = 1.0F / plan.unit,
                             .firstLeaf = plan.firstLeaf,
                             .boxes = boxes,
                             .faces = faces,
                             .searches = nodes};
  const gl::Defines defines = gl::kernelDefines(false);
  const gl::Kernel<DistanceMeasure> measure(defines);
  for (bool begins = true;; begins = false) {
    left.write(0, std::as_bytes(std::span(none)));
    measure.dispatch(plan.nodeCount(),
                     {.part = part, .rounds = roundsOfSearch, .begins = begins, .left = left});
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    if (left.readAll<unsigned>()[0] == 0) break;
  }
  gl::Kernel<DistanceSign>(defines).dispatch(plan.nodeCount(), {.part = part});
  gl::Kernel<DistancePack>(defines).dispatch(plan.cellCount(),
                                             {.part = part, .firstCell = mesh.firstCell, .cells = cells_});
}

}  // namespace simreel::sim

#include "sim/collide/distance_fields.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace simreel::shader::distance {
#include "glsl/collide/distance/bindings.glsl"
}  // namespace simreel::shader::distance

namespace simreel::sim {

namespace {

constexpr int roundsOfSearch = 4096;  // and up to leafFaces loops in each

void checkSize(const char* what, std::size_t elements, const char* advice) {
  const std::int64_t most = std::min(gl::limits().storageBlockBytes / 16, gl::limits().texelBufferTexels);
  if (static_cast<std::int64_t>(elements) > most)
    fail(ExitCode::device,
         "the {} of the meshes that collide are {} elements of 16 bytes, this device allows {} in one "
         "buffer; {}",
         what, elements, most, advice);
}

}  // namespace

constinit const PortInfo DistanceFields::port = {
    .name = "distance fields", .lacks = ", which is no rigid mesh", .none = "the scene has no rigid mesh"};

DistanceFields::DistanceFields(MeshColliderPlan plan) : plan_(std::move(plan)) {
  checkSize("cells", static_cast<std::size_t>(plan_.cellCount()), "lower \"distanceCells\"");
  cells_ = gl::WordsArray("distance fields", plan_.cellCount());
  for (const MeshColliderPlan::Part& part : plan_.parts()) make(part);
}

void DistanceFields::make(const MeshColliderPlan::Part& part) {
  namespace names = shader::distance;
  const DistancePlan& plan = part.plan;
  checkSize("faces", plan.faces.size(), "take a coarser mesh");
  checkSize("nodes", static_cast<std::size_t>(plan.nodeCount()), "lower \"distanceCells\"");
  const gl::Vec4Array boxes(part.name + " boxes", plan.boxes);
  const gl::Vec4Array faces(part.name + " faces", plan.faces);
  gl::WordsArray nodes(part.name + " distances", plan.nodeCount());
  const unsigned none[4] = {};
  gl::Buffer left = gl::Buffer::of<unsigned>(part.name + " left", none);
  const auto make = [&](const char* path) {
    gl::Program program = gl::Program::compute(path, gl::kernelDefines(false));
    program.set("nodes", glm::ivec4(plan.cells + 1, plan.nodeCount()));
    program.set("corner", glm::vec4(plan.corner, plan.cell));
    program.set("perUnit", 1.0F / plan.unit);
    program.set("firstLeaf", plan.firstLeaf);
    return program;
  };
  boxes.bindInput(names::boxesBinding);
  faces.bindInput(names::facesBinding);
  nodes.bindState(names::nodesBinding);
  left.bindStorage(names::leftBinding);
  const gl::Program measure = make("collide/distance/measure.comp");
  measure.set("rounds", roundsOfSearch);
  for (bool begins = true;; begins = false) {
    left.write(0, std::as_bytes(std::span(none)));
    measure.set("begins", begins ? 1 : 0);
    gl::barrier();
    measure.dispatch(plan.nodeCount());
    gl::barrier();
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    if (left.readAll<unsigned>()[0] == 0) break;
  }
  make("collide/distance/sign.comp").dispatch(plan.nodeCount());
  gl::barrier();
  cells_.bindState(names::cellsBinding);
  const gl::Program pack = make("collide/distance/pack.comp");
  pack.set("firstCell", part.firstCell);
  pack.dispatch(plan.cellCount());
  gl::barrier();
}

MeshTouch::MeshTouch(const std::string& name, const DistanceFields* fields, int substeps,
                     double substepSeconds)
    : fields_(fields), substeps_(substeps), substepSeconds_(substepSeconds) {
  if (fields_ != nullptr) steps_ = StepBlocks<shader::MeshColliders>(name + " meshes", substeps);
}

void MeshTouch::addDefines(gl::Defines& defines) const {
  defines.emplace_back("MESHES", std::to_string(count()));
}

void MeshTouch::check(const gl::Program& kernel) const {
  if (fields_ != nullptr) kernel.checkUniformBlock("MeshColliderBlock", sizeof(shader::MeshColliders));
}

void MeshTouch::beginFrame(double time) {
  if (fields_ != nullptr) steps_.upload(fields_->plan().frame(time, substeps_, substepSeconds_));
}

void MeshTouch::bind(int substep) const {
  if (fields_ == nullptr) return;
  steps_.bind(static_cast<std::size_t>(substep), shader::meshCollidersBinding);
  fields_->cells().bindInput(shader::fieldCellsBinding);
}

}  // namespace simreel::sim

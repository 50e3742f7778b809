#include "sim/mesh/deform.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/sort/radix_sort.hpp"
#include "sim/contact/solid.hpp"
#include "sim/core/position_readback.hpp"
#include "sim/core/stage_times.hpp"
#include "sim/mesh/buffers.hpp"
#include "sim/mesh/deform_cpu.hpp"
#include "sim/mesh/deform_plan.hpp"
#include "sim/mesh/height_field.hpp"
#include "sim/mesh/looks.hpp"
#include "sim/mesh/quantities.hpp"
#include "sim/ports/landform.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <utility>

namespace simreel::sim {

namespace {

/// Deformed positions and normals in buffers that draw calls read.
struct Vertices {
  gl::Vec4Array positions, normals;
  GLsync drawn = nullptr;  ///< fence that is signalled when the GPU has read the mapped slot
};

struct PressKernel {
  static constexpr auto file = "mesh/press.comp";
  gl::Block<"DeformBlock", shader::DeformStep> step;
  gl::InOut<"trail"> trail;
};

struct DisplaceKernel {
  static constexpr auto file = "mesh/displace.comp";
  struct Variant {
    gl::Range<"DISPLACEMENTS", 0, shader::maxDisplacements> displacements;
    gl::Code<"FIRST_KINDS", "0"> firstKinds;  // displacement kinds packed with four bits each
    gl::Code<"LAST_KINDS", "0"> lastKinds;
  };
  gl::Block<"DeformBlock", shader::DeformStep> step;
  gl::In<"restPositions"> restPositions;
  gl::In<"trail"> trail;
  gl::Out<"positions"> positions;
};

struct NormalKernel {
  static constexpr auto file = "mesh/normal.comp";
  gl::Block<"DeformBlock", shader::DeformStep> step;
  gl::In<"positions"> positions;
  gl::In<"restNormals"> restNormals;
  gl::In<"fans"> fans;
  gl::In<"faces"> faces;
  gl::Out<"normals"> normals;
};

class DeformedMesh : public Simulation, public ContactSolid, public Landform {
 public:
  DeformedMesh(const scene::Object& object, const MeshParameters& parameters, const Mesh& mesh,
               const Setting& setting)
      : name_(object.name),
        parameters_(parameters),
        technique_(parameters.deform.technique),
        frameSeconds_(setting.frameSeconds),
        plan_(name_, parameters, mesh, *setting.colliders),
        rest_(name_, mesh),
        cpu_(rest_, plan_.trailCells()),
        topology_(name_, mesh),
        looks_(object, mesh),
        restPositions_(name_ + " rest positions", rest_.positions),
        restNormals_(name_ + " rest normals", rest_.normals),
        trail_(name_ + " trail", cpu_.trail()),
        block_(name_ + " deformation", sizeof(shader::DeformStep)),
        clock_(!setting.timing ? StageClock::Of::nothing
               : onDevice()    ? StageClock::Of::gpu
                               : StageClock::Of::cpu) {
    makeVertices();
    if (onDevice()) makePrograms(setting.fast);
    if (parameters.collides) {
      heights_.emplace(name_, HeightPlan(parameters, frameSeconds_));
      deform(setting.startTime);
      heights_->setHeights(shown().positions);
    }
    if (parameters.byFaces) time_ = setting.startTime;
    if (parameters.byFaces) touched_.emplace(name_, rest_.positions, setting.fast);
    deform(parameters.byFaces ? setting.startTime : 0.0);
  }
  ~DeformedMesh() override {
    for (const Vertices& v : vertices_)
      if (v.drawn != nullptr) glDeleteSync(v.drawn);
  }
  DeformedMesh(const DeformedMesh&) = delete;
  DeformedMesh& operator=(const DeformedMesh&) = delete;

  void step(double time, const StepWatch& watch) override {
    time_ = time + frameSeconds_;
    if (touched_) {
      deform(time);
      touched_->takeBegin(shown().positions);
    }
    if (plan_.hasTrail()) press(time_);
    deform(time_);
    if (heights_) heights_->setHeights(shown().positions);
    if (touched_) {
      touched_->takeEnd(shown().positions);
      touched_->place(parameters_.model(time), parameters_.model(time_));
    }
    if (watch) watch(1);
  }

  /// Vertex positions depend only on time, so skipped frames need no deformation, with two exceptions:
  /// footprint trails must be pressed in every frame, and collisions need the heights or faces of two
  /// consecutive frames.
  void pass(double time) override {
    if (heights_ || touched_) return step(time, {});
    time_ = time + frameSeconds_;
    if (plan_.hasTrail()) press(time_);
  }

  void visitCheckpointData(CarryOver& carry) override {
    if (plan_.hasTrail()) carry.array("trail", trail_.buffer());
    if (heights_) heights_->visitCheckpointData(carry);
  }
  void resumed(double time) override {
    time_ = time;
    if (plan_.hasTrail() && !onDevice()) cpu_.setTrail(trail_.buffer().readAll<glm::vec4>());
    deform(time);
  }

  [[nodiscard]] double jumpedBy(double time) const override { return parameters_.jumpedBy(time); }

  void publish(double time, Drawables& drawables) const override {
    if (!parameters_.visible) return;
    Surface surface = topology_.surface();
    const bool late = technique_ == DeformTechnique::vertexShader;
    surface.positions = late ? &restPositions_.view() : &shown().positions.view();
    surface.normals = late ? &restNormals_.view() : &shown().normals.view();
    surface.deform = late ? &block_ : nullptr;
    surface.trail = late ? &trail_.view() : nullptr;
    surface.model = parameters_.model(time);
    surface.doubleSided = parameters_.doubleSided();
    looks_.publish(surface, drawables);
  }

  [[nodiscard]] std::vector<StateArray> state() const override {
    std::vector<StateArray> arrays;
    if (technique_ != DeformTechnique::vertexShader)
      arrays.push_back({"positions", &shown().positions.buffer()});
    if (plan_.hasTrail()) arrays.push_back({"trail", &trail_.buffer()});
    return arrays;
  }
  [[nodiscard]] std::string elementName(long element) const override {
    return "vertex " + std::to_string(element);
  }
  [[nodiscard]] MeshTable landform() const override { return *mesh(); }
  [[nodiscard]] std::optional<MeshTable> mesh() const override;
  void connect(Outlets& outlets) override {
    if (heights_) outlets.provide(&*heights_);
    if (touched_) outlets.provide<ContactSolid>(this);
  }
  [[nodiscard]] ContactPart contactPart() const override {
    const MeshTable table = *mesh();
    return solidPart(table.positions, table.indices, parameters_.friction);
  }
  void moveTo(int substep, int substeps) override { touched_->moveTo(substep, substeps); }
  [[nodiscard]] const gl::Vec4Array& now() const override { return touched_->now(); }
  [[nodiscard]] const gl::Vec4Array& next() const override { return touched_->next(); }
  [[nodiscard]] std::vector<double> measure() const override { return measureMesh(*mesh()); }
  [[nodiscard]] std::vector<std::pair<const char*, double>> stageTimes() const override {
    return clock_.times();
  }

 private:
  [[nodiscard]] bool onDevice() const {
    return technique_ == DeformTechnique::compute || technique_ == DeformTechnique::vertexShader;
  }
  [[nodiscard]] Threads threads() const {
    return technique_ == DeformTechnique::singleThread ? Threads::one : Threads::all;
  }
  [[nodiscard]] const Vertices& shown() const { return vertices_[current_]; }

  void makeVertices();
  void makePrograms(bool fast);
  void press(double time);
  void deform(double time);
  void deformOnDevice();
  void deformMapped(const shader::DeformStep& step);
  void deformOnCpu(const shader::DeformStep& step);

  std::string name_;
  MeshParameters parameters_;
  DeformTechnique technique_;
  double frameSeconds_;
  double time_ = 0;  ///< time of the current positions in seconds
  DeformPlan plan_;
  RestMesh rest_;
  mutable DeformCpu cpu_;  ///< CPU results; for GPU techniques they are computed only on request
  MeshTopology topology_;
  MovingMeshMaterials looks_;
  gl::Vec4Array restPositions_, restNormals_;
  gl::Vec4Array trail_;
  gl::Buffer block_;
  StageClock clock_;
  std::array<Vertices, 3> vertices_;  ///< vertex buffers: three slots for the technique `mapped`, otherwise
                                      ///< one
  std::size_t current_ = 0;
  gl::WordsArray fans_, faces_;
  gl::Kernel<PressKernel> press_;
  gl::Kernel<DisplaceKernel> displace_;
  gl::Kernel<NormalKernel> gather_;
  std::unique_ptr<PositionReadback> readback_;
  std::optional<HeightField> heights_;    ///< set only for a mesh that collides as a height field
  std::optional<MovedVertices> touched_;  ///< set only for a mesh whose faces collide
};

void DeformedMesh::makeVertices() {
  if (technique_ == DeformTechnique::vertexShader) return;
  const bool mapped = technique_ == DeformTechnique::mapped;
  const std::size_t bytes = rest_.positions.size() * sizeof(glm::vec4);
  for (std::size_t i = 0; i < (mapped ? vertices_.size() : 1); ++i) {
    const auto make = [&](const char* what, const std::vector<glm::vec4>& first) {
      const std::string label = name_ + what;
      return mapped ? gl::Vec4Array(label, gl::Buffer::mapped(label, bytes, true))
                    : gl::Vec4Array(label, first);
    };
    vertices_[i].positions = make(" positions", rest_.positions);
    vertices_[i].normals = make(" normals", rest_.normals);
  }
}

void DeformedMesh::makePrograms(bool fast) {
  const gl::Defines defines = gl::kernelDefines(fast);
  if (plan_.hasTrail()) press_ = gl::Kernel<PressKernel>(defines);
  if (technique_ != DeformTechnique::compute) return;
  gather_ = gl::Kernel<NormalKernel>(defines);
  const shader::DeformStep step = plan_.at(0);
  static_assert(shader::maxDisplacements == 16);
  std::uint32_t kinds[2] = {0, 0};
  for (int i = 0; i < step.displacementCount; ++i)
    kinds[i / 8] |= static_cast<std::uint32_t>(step.displacements[i].kind) << (4 * (i % 8));
  displace_ = gl::Kernel<DisplaceKernel>(
      defines, {.displacements = step.displacementCount,
                .firstKinds = fmt::format("{}", std::bit_cast<std::int32_t>(kinds[0])),
                .lastKinds = fmt::format("{}", std::bit_cast<std::int32_t>(kinds[1]))});
  fans_ = gl::WordsArray(name_ + " fans", static_cast<int>(rest_.fans.size()));
  fans_.write(rest_.fans);
  faces_ = gl::WordsArray(name_ + " faces", static_cast<int>(rest_.faces.size()));
  faces_.write(rest_.faces);
  if (parameters_.deform.readback)
    readback_ = std::make_unique<PositionReadback>(name_ + " readback", rest_.positions.size());
}

void DeformedMesh::press(double time) {
  const shader::DeformStep step = plan_.swept(time - frameSeconds_, time);
  if (!onDevice()) {
    cpu_.press(step, threads());
    trail_.write(cpu_.trail());
    return;
  }
  block_.write(0, std::as_bytes(std::span(&step, 1)));
  press_.dispatch(plan_.trailCells(), {.step = block_, .trail = trail_});
  gl::barrier();
}

void DeformedMesh::deform(double time) {
  const shader::DeformStep step = plan_.at(time);
  clock_.begin();
  if (onDevice()) block_.write(0, std::as_bytes(std::span(&step, 1)));
  switch (technique_) {
    case DeformTechnique::compute:
      deformOnDevice();
      break;
    case DeformTechnique::vertexShader:
      gl::barrier();
      break;
    case DeformTechnique::mapped:
      deformMapped(step);
      break;
    default:
      deformOnCpu(step);
  }
  clock_.end();
}

void DeformedMesh::deformOnDevice() {
  const int count = static_cast<int>(rest_.positions.size());
  gl::barrier();
  displace_.dispatch(
      count,
      {.step = block_, .restPositions = restPositions_, .trail = trail_, .positions = shown().positions});
  clock_.lap(&StageTimes::deform);
  gather_.dispatch(count, {.step = block_,
                           .positions = shown().positions,
                           .restNormals = restNormals_,
                           .fans = fans_,
                           .faces = faces_,
                           .normals = shown().normals});
  gl::barrier();
  clock_.lap(&StageTimes::normals);
  if (!readback_) return;
  readback_->start(shown().positions.buffer());
  clock_.lap(&StageTimes::transfer);
}

void DeformedMesh::deformOnCpu(const shader::DeformStep& step) {
  cpu_.displace(step, threads());
  clock_.lap(&StageTimes::deform);
  cpu_.gatherNormals(threads());
  clock_.lap(&StageTimes::normals);
  vertices_[0].positions.write(cpu_.positions());
  vertices_[0].normals.write(cpu_.normals());
  clock_.lap(&StageTimes::transfer);
}

void DeformedMesh::deformMapped(const shader::DeformStep& step) {
  // At this point, all commands that read the current slot have been issued.
  Vertices& drawn = vertices_[current_];
  if (drawn.drawn == nullptr) drawn.drawn = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  current_ = (current_ + 1) % vertices_.size();
  Vertices& next = vertices_[current_];
  pollFence(next.drawn, true);
  clock_.lap(&StageTimes::transfer);
  const auto memory = [&](const gl::Vec4Array& array) {
    return std::span(static_cast<glm::vec4*>(array.buffer().memory()), rest_.positions.size());
  };
  cpu_.displace(step, Threads::all, memory(next.positions));
  clock_.lap(&StageTimes::deform);
  cpu_.gatherNormals(Threads::all, memory(next.normals));
  clock_.lap(&StageTimes::normals);
}

std::optional<MeshTable> DeformedMesh::mesh() const {
  std::vector<glm::vec4> positions;
  std::vector<glm::vec4> normals;
  if (technique_ == DeformTechnique::compute) {
    // On a slow GPU, the copy of the latest frame may have been skipped.
    const bool copied = readback_ && readback_->current();
    positions = copied ? readback_->wait() : shown().positions.buffer().readAll<glm::vec4>();
    normals = shown().normals.buffer().readAll<glm::vec4>();
  } else {
    if (technique_ == DeformTechnique::vertexShader) {
      if (plan_.hasTrail()) cpu_.setTrail(trail_.buffer().readAll<glm::vec4>());
      cpu_.displace(plan_.at(time_), Threads::all);
      cpu_.gatherNormals(Threads::all);
    }
    positions = cpu_.positions();
    normals = cpu_.normals();
  }
  MeshTable table = placed(positions, normals, parameters_.model(time_));
  topology_.complete(table);
  table.doubleSided = parameters_.doubleSided();
  return table;
}

}  // namespace

std::unique_ptr<Simulation> makeDeformedMesh(const scene::Object& object, const MeshParameters& parameters,
                                             const Mesh& mesh, const Setting& setting) {
  return std::make_unique<DeformedMesh>(object, parameters, mesh, setting);
}

}  // namespace simreel::sim

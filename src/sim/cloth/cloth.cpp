#include "sim/cloth/cloth.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "gl/element_array.hpp"
#include "gl/limits.hpp"
#include "sim/body/bones.hpp"
#include "sim/cloth/kernels.hpp"
#include "sim/cloth/plan.hpp"
#include "sim/cloth/quantities.hpp"
#include "sim/contact/lock_step.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/step_blocks.hpp"
#include "sim/grid/sheet_mesh.hpp"
#include "sim/touch/touch.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace simreel::sim {

namespace {

/// Throws UserError(device) if the index buffer would exceed the device's limit. Called before any array is
/// filled, because a cloth far beyond the limit would first allocate gigabytes.
glm::ivec2 checked(const std::string& name, glm::ivec2 size) {
  const auto bytes = std::int64_t{24} * (size.x - 1) * (size.y - 1);
  const std::int64_t max = gl::limits().storageBlockBytes;
  if (bytes > max)
    fail(ExitCode::device,
         "cloth \"{}\" of {}x{} particles needs {} bytes of indices, this device allows {} in one buffer "
         "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE); make it smaller",
         name, size.x, size.y, bytes, max);
  return size;
}

class Cloth : public Simulation, public LockStep {
 public:
  Cloth(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        material_(parametersOf<ClothParameters>(object).coloring.used() ? ClothColoring::materialOf(object)
                                                                        : object.material),
        plan_(parametersOf<ClothParameters>(object).withContactSubsteps(setting.together<LockStep>().steps),
              setting.seed, setting.frameSeconds, *setting.colliders, boneNamedIn(setting),
              setting.startTime, heldBySkinIn(setting)),
        size_(checked(name_, plan_.parameters().size)),
        frameSeconds_(setting.frameSeconds),
        touch_(name_, setting, touchedBy(plan_)),
        kernels_(name_, plan_, touch_.variant(), setting.fast),
        steps_(name_ + " steps", plan_.substeps()) {
    const ClothParameters& p = plan_.parameters();
    if (p.pinsByDefault)
      infoLineOnce(
          fmt::format("cloth \"{}\": its last row is pinned (default); \"pins\": [] lets it fall", name_));
    indices_ = gl::Buffer::of<unsigned>(name_ + " indices", gridIndices(size_));
    const unsigned fine[4] = {0xffffffffU, 0xffffffffU, 0, 0};
    status_ = gl::Buffer::of<unsigned>(name_ + " status", fine);
    if (!p.coloring.used()) return;
    colors_.emplace(name_, p.coloring, size_, p.spacing, plan_.substepSeconds(), setting.fast);
    updateColors();
  }

  void step(double time, const StepWatch& watch) override {
    beginFrame(time);
    for (int i = 0; i < plan_.substeps(); ++i) {
      predict(i);
      finish();
      if (watch) watch(i + 1);
    }
    endFrame(time);
  }

  void connect(Outlets& outlets) override {
    if (plan_.parameters().contact) outlets.provide<LockStep>(this);
  }
  [[nodiscard]] ContactPart contactPart() const override {
    const ClothParameters& p = plan_.parameters();
    const std::vector<unsigned> corners = gridIndices(size_);
    ContactPart part{plan_.firstPositions(), {}, p.contactThickness(p.spacing), p.contact->friction, {}};
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
      part.faces.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
    part.name = name_;
    return part;
  }
  void beginFrame(double time) override {
    steps_.upload(plan_.frame(time));
    touch_.beginFrame(time);
    kernels_.beginFrame(time, time + frameSeconds_);
  }
  void predict(int substep) override {
    gl::barrier();
    kernels_.predict(substep, partAt(substep));
  }
  [[nodiscard]] Contact::Part arrays() const override {
    return {&kernels_.positions(), &kernels_.nextPositions(), &kernels_.velocities(),
            kernels_.hasTrends() ? &kernels_.trends() : nullptr};
  }
  void settle(int substep) override {
    gl::barrier();
    kernels_.settle(partAt(substep));
  }
  void finish() override { kernels_.finish(); }
  void endFrame(double time) override {
    gl::barrier();
    updateColors();
    time_ = time + frameSeconds_;
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.substeps(); }
  [[nodiscard]] std::string elementName(long element) const override {
    return fmt::format("particle ({}, {})", element % size_.x, element / size_.x);
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    Surface surface;
    surface.positions = &kernels_.positions().view();
    surface.grid = size_;
    surface.vertexCount = size_.x * size_.y;
    surface.indices = &indices_;
    surface.indexCount = (size_.x - 1) * (size_.y - 1) * 6;
    surface.doubleSided = true;
    surface.material = &material_;
    if (colors_) colors_->applyTo(surface);
    drawables.surfaces.push_back(surface);
  }

  void visitCheckpointData(CarryOver& carry) override {
    plan_.visitCheckpointData(carry);
    carry.array("positions", kernels_.positions().buffer());
    carry.array("velocities", kernels_.velocities().buffer());
    if (kernels_.hasTrends()) carry.array("trends", kernels_.trends().buffer());
    if (colors_) carry.array("positions before", kernels_.nextPositions().buffer());
  }
  void resumed(double time) override {
    time_ = time;
    updateColors();
  }

  [[nodiscard]] std::vector<StateArray> state() const override {
    std::vector<StateArray> arrays = {{"positions", &kernels_.positions().buffer()},
                                      {"velocities", &kernels_.velocities().buffer()}};
    if (kernels_.hasTrends()) arrays.push_back({"trends", &kernels_.trends().buffer()});
    return arrays;
  }
  [[nodiscard]] PointTable points() const override {
    const auto positions = kernels_.positions().buffer().readAll<glm::vec4>();
    const auto velocities = shownVelocities(positions);
    PointTable table{{"x", "y", "z", "vx", "vy", "vz"}, {}};
    table.values.reserve(positions.size() * table.columns.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
      table.values.insert(table.values.end(), {positions[i].x, positions[i].y, positions[i].z,
                                               velocities[i].x, velocities[i].y, velocities[i].z});
    return table;
  }
  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    return sheetMesh(size_, kernels_.positions().buffer().readAll<glm::vec4>());
  }
  [[nodiscard]] const gl::Buffer* status() const override { return &status_; }
  [[nodiscard]] std::vector<double> measure() const override {
    const auto positions = kernels_.positions().buffer().readAll<glm::vec4>();
    return measureCloth(plan_.parameters(), positions, shownVelocities(positions), time_, plan_.softness());
  }
  [[nodiscard]] std::string explainLoss(unsigned step, unsigned element) const override {
    const auto width = static_cast<unsigned>(size_.x);
    const bool fabric = plan_.parameters().fabric.has_value();
    return fmt::format(
        "cloth \"{}\" blew up in substep {} at particle ({}, {}): its position or velocity is no longer a "
        "sensible number; use more substeps ({} per frame now, or \"auto\"){}, {}",
        name_, step, element % width, element / width, plan_.substeps(),
        !plan_.parameters().constrained() ? " or \"solver\": \"constraints\"" : "",
        fabric ? "or a heavier fabric" : "lower the stiffness or raise the mass");
  }

 private:
  [[nodiscard]] std::vector<glm::vec4> shownVelocities(const std::vector<glm::vec4>& positions) const {
    return actualVelocities(
        positions, kernels_.velocities().buffer().readAll<glm::vec4>(),
        kernels_.hasTrends() ? kernels_.trends().buffer().readAll<glm::vec4>() : std::vector<glm::vec4>());
  }

  void updateColors() {
    if (colors_)
      colors_->update({.positions = &kernels_.positions(),
                       .before = &kernels_.nextPositions(),
                       .velocities = &kernels_.velocities(),
                       .trends = kernels_.hasTrends() ? &kernels_.trends() : nullptr});
  }
  [[nodiscard]] ClothPart partAt(int substep) const {
    return {.size = size_,
            .step = steps_.at(static_cast<std::size_t>(substep)),
            .status = status_,
            .touch = touch_.at(substep)};
  }

  std::string name_;
  scene::Material material_;
  ClothPlan plan_;
  glm::ivec2 size_;
  double frameSeconds_;
  double time_ = 0;  ///< time of the current state in seconds
  Touch touch_;
  ClothKernels kernels_;
  gl::Buffer indices_;
  gl::Buffer status_;
  StepBlocks<shader::ClothStep> steps_;
  std::optional<ClothColors> colors_;  ///< empty if the cloth has the material's colour
};

}  // namespace

std::unique_ptr<Simulation> makeSheet(const scene::Object& object, const Setting& setting) {
  return makeSimulation<Cloth>(object, setting);
}

void checkSheet(const scene::Object& object, const Setting& setting) {
  static_cast<void>(ClothPlan(parametersOf<ClothParameters>(object), setting.seed, setting.frameSeconds,
                              *setting.colliders, boneNamedIn(setting), setting.startTime,
                              heldBySkinIn(setting)));
}

}  // namespace simreel::sim

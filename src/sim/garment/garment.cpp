#include "sim/garment/garment.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "gl/element_array.hpp"
#include "sim/body/bones.hpp"
#include "sim/cloth/cloth.hpp"
#include "sim/contact/lock_step.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/step_blocks.hpp"
#include "sim/garment/kernels.hpp"
#include "sim/garment/plan.hpp"
#include "sim/garment/quantities.hpp"
#include "sim/mesh/buffers.hpp"
#include "sim/mesh/looks.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace simreel::sim {

namespace {

class Garment : public Simulation, public LockStep {
 public:
  Garment(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        plan_(object.name,
              parametersOf<ClothParameters>(object).withContactSubsteps(setting.together<LockStep>().steps),
              setting.seed, setting.frameSeconds, *setting.colliders, boneNamedIn(setting),
              setting.startTime, heldBySkinIn(setting)),
        frameSeconds_(setting.frameSeconds),
        touch_(name_, setting, touchedBy(plan_)),
        kernels_(name_, plan_, touch_.variant(), setting.fast),
        steps_(name_ + " steps", plan_.substeps()),
        topology_(name_, plan_.mesh()) {
    if (const std::string ignored = ignoredLooks(object, plan_.mesh()); !ignored.empty())
      warn("cloth \"{}\": {} has features that are not drawn: {}", name_,
           plan_.parameters().mesh->file.string(), ignored);
    if (const ClothColoring& coloring = plan_.parameters().coloring; coloring.used()) {
      material_ = ClothColoring::materialOf(object);
      colors_.emplace(name_, coloring, edgesOf(plan_.cloth()), plan_.substepSeconds(), setting.fast);
    } else {
      looks_.emplace(object, plan_.mesh());
    }
    prepareDrawing();
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
    ContactPart part{plan_.firstPositions(), {}, 0, p.contact->friction, plan_.contactRooms()};
    part.positions.resize(part.rooms.size());  // removes the ghost points of clamped edges
    part.name = name_;
    for (const glm::uvec4& face : plan_.arrays().corners) part.faces.emplace_back(face);
    double sum = 0;
    for (const float room : part.rooms) sum += room;
    part.thickness = p.contactThickness(
        static_cast<float>(sum / (roomOfHeight * static_cast<double>(part.rooms.size()))));
    return part;
  }
  void beginFrame(double time) override {
    begun_ = plan_.stepsBegun();
    steps_.upload(plan_.frame(time));
    touch_.beginFrame(time);
    kernels_.beginFrame(time, time + frameSeconds_);
  }
  void predict(int substep) override {
    gl::barrier();
    kernels_.predict(substep, steps_.at(static_cast<std::size_t>(substep)),
                     plan_.bendingAt(begun_ + substep), touch_.at(substep));
  }
  void settle(int substep) override {
    gl::barrier();
    kernels_.settle(steps_.at(static_cast<std::size_t>(substep)), touch_.at(substep));
  }
  [[nodiscard]] Contact::Part arrays() const override {
    return {&kernels_.positions(), &kernels_.nextPositions(), &kernels_.velocities(), &kernels_.trends()};
  }
  void finish() override { kernels_.finish(); }
  void endFrame(double time) override {
    gl::barrier();
    time_ = time + frameSeconds_;
    prepareDrawing();
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.substeps(); }
  [[nodiscard]] std::string elementName(long element) const override {
    return fmt::format("vertex {}", element);
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    Surface surface = topology_.surface();
    surface.positions = &kernels_.drawnPositions().view();
    surface.normals = &kernels_.drawnNormals().view();
    surface.doubleSided = true;
    if (looks_) return looks_->publish(surface, drawables);
    surface.material = &material_;
    colors_->applyTo(surface);
    drawables.surfaces.push_back(surface);
  }

  void visitCheckpointData(CarryOver& carry) override {
    plan_.visitCheckpointData(carry);
    carry.array("positions", kernels_.positions().buffer());
    carry.array("velocities", kernels_.velocities().buffer());
    carry.array("trends", kernels_.trends().buffer());
    if (colors_) carry.array("positions before", kernels_.nextPositions().buffer());
  }
  void resumed(double time) override {
    time_ = time;
    prepareDrawing();
  }

  [[nodiscard]] std::vector<StateArray> state() const override {
    return {{"positions", &kernels_.positions().buffer()},
            {"velocities", &kernels_.velocities().buffer()},
            {"trends", &kernels_.trends().buffer()}};
  }
  [[nodiscard]] PointTable points() const override {
    const auto positions = kernels_.positions().buffer().readAll<glm::vec4>();
    const auto velocities = shownVelocities(positions);
    PointTable table{{"x", "y", "z", "vx", "vy", "vz"}, {}};
    for (const unsigned i : plan_.cloth().vertexOf)
      table.values.insert(table.values.end(), {positions[i].x, positions[i].y, positions[i].z,
                                               velocities[i].x, velocities[i].y, velocities[i].z});
    return table;
  }
  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    MeshTable table;
    table.uvs = plan_.mesh().uvs;
    table.indices = plan_.mesh().indices;
    for (const glm::vec4& p : kernels_.drawnPositions().buffer().readAll<glm::vec4>())
      table.positions.emplace_back(p);
    for (const glm::vec4& n : kernels_.drawnNormals().buffer().readAll<glm::vec4>())
      table.normals.emplace_back(n);
    return table;
  }
  [[nodiscard]] const gl::Buffer* status() const override { return &kernels_.status(); }
  [[nodiscard]] std::vector<double> measure() const override {
    const auto positions = kernels_.positions().buffer().readAll<glm::vec4>();
    return measureGarment(plan_, positions, shownVelocities(positions), time_);
  }
  [[nodiscard]] std::string explainLoss(unsigned step, unsigned element) const override {
    return fmt::format(
        "cloth \"{}\" blew up in substep {} at vertex {}: its position or velocity is no longer a sensible "
        "number; use more substeps ({} per frame now, or \"auto\"), or a heavier fabric",
        name_, step, element, plan_.substeps());
  }

 private:
  /// Computes the data for drawing the current state.
  void prepareDrawing() {
    kernels_.prepareDrawing(steps_.at(0));
    if (colors_)
      colors_->update({.positions = &kernels_.positions(),
                       .before = &kernels_.nextPositions(),
                       .velocities = &kernels_.velocities(),
                       .trends = plan_.parameters().keepsEnergy() ? nullptr : &kernels_.trends()});
  }
  [[nodiscard]] std::vector<glm::vec4> shownVelocities(const std::vector<glm::vec4>& positions) const {
    const bool keeps = plan_.parameters().keepsEnergy();
    return actualVelocities(
        positions, kernels_.velocities().buffer().readAll<glm::vec4>(),
        keeps ? std::vector<glm::vec4>() : kernels_.trends().buffer().readAll<glm::vec4>());
  }
  std::string name_;
  GarmentPlan plan_;
  double frameSeconds_;
  double time_ = 0;  ///< time of the current state in seconds
  int begun_ = 0;    ///< number of substeps before the current frame
  Touch touch_;
  GarmentKernels kernels_;
  StepBlocks<shader::ClothStep> steps_;
  MeshTopology topology_;
  std::optional<MovingMeshMaterials> looks_;  ///< empty if the vertices are coloured by a quantity
  scene::Material material_;
  std::optional<ClothColors> colors_;
};

}  // namespace

SimulationKind clothKind() {
  return kindOf<ClothParameters>(
      "cloth",
      "A sheet of particles held together by springs, or a mesh of fabric, in wind and over colliders.",
      [](const scene::Object& object, const Setting& setting) {
        const auto& parameters = parametersOf<ClothParameters>(object);
        if (!parameters.mesh) return checkSheet(object, setting);
        static_cast<void>(GarmentPlan(object.name, parameters, setting.seed, setting.frameSeconds,
                                      *setting.colliders, boneNamedIn(setting), setting.startTime,
                                      heldBySkinIn(setting)));
      },
      [](const scene::Object& object, const Setting& setting) {
        if (parametersOf<ClothParameters>(object).mesh) return makeSimulation<Garment>(object, setting);
        return makeSheet(object, setting);
      });
}

}  // namespace simreel::sim

#include "sim/body/body.hpp"

#include "base/log.hpp"
#include "sim/body/model_scene.hpp"
#include "sim/body/motion.hpp"
#include "sim/body/skinned_surface.hpp"
#include "sim/contact/solid.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/moments.hpp"
#include "sim/mesh/buffers.hpp"
#include "sim/mesh/looks.hpp"
#include "sim/mesh/quantities.hpp"

#include <algorithm>
#include <utility>

namespace simreel::sim {

namespace {

/// Skinned mesh whose vertex positions depend only on the time.
class Body : public Simulation, public ContactSolid {
 public:
  Body(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        parameters_(parametersOf<BodyParameters>(object)),
        frameSeconds_(setting.frameSeconds),
        motion_(name_, parameters_),
        topology_(name_, motion_.figure().mesh),
        looks_(object, motion_.figure().mesh),
        surface_(name_, motion_.figure(), setting.fast) {
    if (const std::string ignored = ignoredLooks(object, motion_.figure().mesh); !ignored.empty())
      warn("body \"{}\": {} has features that are not drawn: {}", name_, parameters_.file.string(),
           ignored);
    resumed(setting.startTime);
  }

  void step(double time, const StepWatch& watch) override {
    surface_.begin(motion_.rowsAt(time), motion_.rowsAt(time + frameSeconds_));
    if (watch) watch(1);
  }
  void resumed(double time) override { surface_.begin(motion_.rowsAt(time), motion_.rowsAt(time)); }

  [[nodiscard]] double jumpedBy(double time) const override {
    double last = lastJump(time, parameters_.position, parameters_.rotation, parameters_.scale);
    for (const KeyedBone& bone : parameters_.bones)
      last = std::max(last, lastJump(time, bone.rotate, bone.move));
    return last;
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    if (!parameters_.visible) return;
    Surface surface = topology_.surface();
    surface.positions = &surface_.positions().view();
    surface.normals = &surface_.normals().view();
    surface.doubleSided = parameters_.doubleSided;
    looks_.publish(surface, drawables);
  }

  [[nodiscard]] std::vector<StateArray> state() const override {
    return {{"positions", &surface_.positions().buffer()}};
  }
  [[nodiscard]] std::string elementName(long element) const override {
    return "vertex " + std::to_string(element);
  }
  void connect(Outlets& outlets) override {
    outlets.provide(&surface_);
    if (parameters_.byFaces) outlets.provide<ContactSolid>(this);
  }
  [[nodiscard]] ContactPart contactPart() const override {
    const MeshTable table = *mesh();
    return solidPart(table.positions, table.indices, parameters_.friction);
  }
  void moveTo(int substep, int substeps) override { surface_.moveTo(substep, substeps); }
  [[nodiscard]] const gl::Vec4Array& now() const override { return surface_.before(); }
  [[nodiscard]] const gl::Vec4Array& next() const override { return surface_.now(); }
  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    MeshTable table;
    table.uvs = motion_.figure().mesh.uvs;
    table.indices = motion_.figure().mesh.indices;
    for (const glm::vec4& p : surface_.positions().buffer().readAll<glm::vec4>())
      table.positions.emplace_back(p);
    for (const glm::vec4& n : surface_.normals().buffer().readAll<glm::vec4>())
      table.normals.emplace_back(n);
    return table;
  }
  [[nodiscard]] std::vector<double> measure() const override { return measureMesh(*mesh()); }

 private:
  std::string name_;
  BodyParameters parameters_;
  double frameSeconds_;
  BodyMotion motion_;
  MeshTopology topology_;
  MovingMeshMaterials looks_;
  SkinnedSurface surface_;
};

}  // namespace

SimulationKind bodyKind() {
  SimulationKind body = kindOf<BodyParameters>(
      "body",
      "A figure or machine of a glTF file that moves: skins follow bones, and other meshes their nodes.",
      [](const scene::Object& object, const Setting& /*setting*/) {
        const BodyMotion motion(object.name, parametersOf<BodyParameters>(object));
        static_cast<void>(looksOf(object, motion.figure().mesh));
      },
      makeSimulation<Body>);
  body.kind.sceneAround = sceneAroundModel;
  return body;
}

}  // namespace simreel::sim

#include "sim/mesh/mesh.hpp"

#include "base/log.hpp"
#include "sim/core/kind.hpp"
#include "sim/mesh/buffers.hpp"
#include "sim/mesh/deform.hpp"
#include "sim/mesh/deform_plan.hpp"
#include "sim/mesh/deform_rest.hpp"
#include "sim/mesh/parameters.hpp"

#include <optional>

namespace simreel::sim {

namespace {

/// A mesh that keeps its shape: scenery, moved by keyframes.
class RigidMesh : public Simulation {
 public:
  RigidMesh(const scene::Object& object, const MeshParameters& parameters, const Mesh& mesh,
            double frameSeconds)
      : parameters_(parameters),
        material_(object.material),
        frameSeconds_(frameSeconds),
        buffers_(object.name, mesh) {}

  void step(double time, const StepWatch& /*watch*/) override { time_ = time + frameSeconds_; }
  void resumed(double time) override { time_ = time; }

  void publish(double time, Drawables& drawables) const override {
    if (!parameters_.visible) return;
    Surface surface = buffers_.surface();
    surface.model = parameters_.model(time);
    surface.doubleSided = parameters_.doubleSided();
    surface.material = &material_;
    drawables.surfaces.push_back(surface);
  }

  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    MeshTable table = buffers_.table(parameters_.model(time_));
    table.doubleSided = parameters_.doubleSided();
    return table;
  }

 private:
  MeshParameters parameters_;
  scene::Material material_;
  double frameSeconds_;
  double time_ = 0;  ///< s, of the present frame
  MeshBuffers buffers_;
};

Mesh readMesh(const scene::Object& object, const Setting& setting) {
  const auto& parameters = parametersOf<MeshParameters>(object);
  Mesh mesh = parameters.make(setting.seed);
  if (mesh.uvs.empty() && object.material.hasSkin &&
      object.material.skin.projection == scene::Skin::Projection::uv)
    warn("mesh \"{}\": {} has no texture coordinates; \"projection\": \"triplanar\" lays its skin without",
         object.name, parameters.file.string());
  if (mesh.uvs.empty() && !object.material.hasSkin && !object.material.texture.empty())
    warn("mesh \"{}\": {} has no texture coordinates, so its texture shows the colour of one corner",
         object.name, parameters.file.string());
  return mesh;
}

void checkMesh(const scene::Object& object, const Setting& setting) {
  const auto& parameters = parametersOf<MeshParameters>(object);
  const Mesh mesh = readMesh(object, setting);
  if (parameters.deform.list.empty()) return;
  static_cast<void>(DeformPlan(object.name, parameters, mesh, *setting.colliders));
  static_cast<void>(RestMesh(object.name, mesh));
}

std::unique_ptr<Simulation> makeMesh(const scene::Object& object, const Setting& setting) {
  const auto& parameters = parametersOf<MeshParameters>(object);
  const Mesh mesh = readMesh(object, setting);
  if (!parameters.deform.list.empty()) return makeDeformedMesh(object, parameters, mesh, setting);
  return std::make_unique<RigidMesh>(object, parameters, mesh, setting.frameSeconds);
}

}  // namespace

SimulationKind meshKind() {
  return kindOf<MeshParameters>(
      "mesh", "A generated mesh or one from a file, that may move along keyframes and be deformed.",
      checkMesh, makeMesh);
}

}  // namespace simreel::sim

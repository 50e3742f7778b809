#include "sim/mesh/mesh.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "sim/contact/solid.hpp"
#include "sim/core/kind.hpp"
#include "sim/mesh/buffers.hpp"
#include "sim/mesh/deform.hpp"
#include "sim/mesh/deform_plan.hpp"
#include "sim/mesh/deform_rest.hpp"
#include "sim/mesh/looks.hpp"
#include "sim/mesh/parameters.hpp"
#include "sim/ports/landform.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::sim {

namespace {

/// Mesh that keeps its shape and is moved by keyframes.
class RigidMesh : public Simulation, public ContactSolid, public Landform {
 public:
  RigidMesh(const scene::Object& object, const MeshParameters& parameters, const Mesh& mesh,
            const Setting& setting)
      : parameters_(parameters),
        material_(fallbackMaterial(object, mesh)),
        frameSeconds_(setting.frameSeconds),
        time_(setting.startTime),
        buffers_(object.name, mesh) {
    for (MaterialPart& look : looksOf(object, mesh)) {
      Part part{std::move(look.material), std::nullopt};
      if (!look.mesh.indices.empty()) part.buffers.emplace(object.name, look.mesh);
      parts_.push_back(std::move(part));
    }
    if (!parameters_.byFaces) return;
    std::vector<glm::vec4> positions;
    for (const glm::vec3& p : mesh.positions) positions.emplace_back(p, 1.0F);
    touched_.emplace(object.name, positions, setting.fast);
  }

  void step(double time, const StepWatch& /*watch*/) override {
    time_ = time + frameSeconds_;
    if (touched_) touched_->place(parameters_.model(time), parameters_.model(time_));
  }
  void resumed(double time) override { time_ = time; }

  [[nodiscard]] double jumpedBy(double time) const override { return parameters_.jumpedBy(time); }

  void publish(double time, Drawables& drawables) const override {
    if (!parameters_.visible) return;
    const auto addSurface = [&](const MeshBuffers& buffers, const scene::Material& material) {
      Surface surface = buffers.surface();
      surface.model = parameters_.model(time);
      surface.doubleSided = parameters_.doubleSided();
      surface.material = &material;
      drawables.surfaces.push_back(surface);
    };
    if (parts_.empty()) addSurface(buffers_, material_);
    for (const Part& part : parts_) addSurface(part.buffers ? *part.buffers : buffers_, part.material);
  }

  [[nodiscard]] MeshTable landform() const override { return *mesh(); }
  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    MeshTable table = buffers_.table(parameters_.model(time_));
    table.doubleSided = parameters_.doubleSided();
    return table;
  }

  void connect(Outlets& outlets) override {
    if (touched_) outlets.provide<ContactSolid>(this);
  }
  [[nodiscard]] ContactPart contactPart() const override {
    const MeshTable table = buffers_.table(parameters_.model(time_));
    return solidPart(table.positions, table.indices, parameters_.friction);
  }
  void moveTo(int substep, int substeps) override { touched_->moveTo(substep, substeps); }
  [[nodiscard]] const gl::Vec4Array& now() const override { return touched_->now(); }
  [[nodiscard]] const gl::Vec4Array& next() const override { return touched_->next(); }

 private:
  /// Part of the mesh with one of the file's materials.
  struct Part {
    scene::Material material;
    std::optional<MeshBuffers> buffers;  ///< buffers of the part; empty for the whole mesh
  };

  MeshParameters parameters_;
  scene::Material material_;
  double frameSeconds_;
  double time_;  ///< time of the current frame in seconds
  MeshBuffers buffers_;
  std::vector<Part> parts_;               ///< one part per material; empty if the whole mesh has material_
  std::optional<MovedVertices> touched_;  ///< set only for a mesh whose faces collide
};

Mesh readMesh(const scene::Object& object, const Setting& setting) {
  const auto& parameters = parametersOf<MeshParameters>(object);
  Mesh mesh = parameters.make(setting.seed);
  if (mesh.uvs.empty() && object.material.skin &&
      object.material.skin->projection == scene::Skin::Projection::uv)
    warn("mesh \"{}\": {} has no texture coordinates; \"projection\": \"triplanar\" lays its skin without",
         object.name, parameters.file.string());
  if (mesh.uvs.empty() && !object.material.skin && !object.material.texture.empty())
    warn("mesh \"{}\": {} has no texture coordinates, so its texture shows the colour of one corner",
         object.name, parameters.file.string());
  if (const std::string ignored = ignoredLooks(object, mesh); !ignored.empty())
    warn("mesh \"{}\": {} has features that are not drawn: {}", object.name, parameters.file.string(),
         ignored);
  return mesh;
}

void checkMesh(const scene::Object& object, const Setting& setting) {
  const auto& parameters = parametersOf<MeshParameters>(object);
  const Mesh mesh = readMesh(object, setting);
  static_cast<void>(looksOf(object, mesh));
  if (parameters.deform.list.empty()) return;
  static_cast<void>(DeformPlan(object.name, parameters, mesh, *setting.colliders));
  static_cast<void>(RestMesh(object.name, mesh));
}

std::unique_ptr<Simulation> makeMesh(const scene::Object& object, const Setting& setting) {
  const auto& parameters = parametersOf<MeshParameters>(object);
  const Mesh mesh = readMesh(object, setting);
  if (!parameters.deform.list.empty()) return makeDeformedMesh(object, parameters, mesh, setting);
  return std::make_unique<RigidMesh>(object, parameters, mesh, setting);
}

/// Returns the JSON text of a scene of one frame that draws a mesh file; empty for other files. Throws
/// UserError(usage) for mesh formats that are not supported.
std::string sceneAroundMesh(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 7> others = {".fbx",  ".dae", ".3ds",  ".usd",
                                                      ".usdz", ".off", ".blend"};
  const std::string extension = lowerExtension(file);
  if (!pathExists(file)) return {};
  if (std::find(others.begin(), others.end(), extension) != others.end())
    fail(ExitCode::usage,
         "{} is a mesh, not a scene, and of a format that is not read; export it as glTF (.glb)",
         file.string());
  if (!isMeshFile(file) || isGltf(file)) return {};  // glTF files are handled by the object kind "body"
  using Json = nlohmann::ordered_json;
  const std::string name = file.filename().string();
  const Json scene = {{"version", 2},
                      {"title", name},
                      {"time", {{"fps", 30}, {"duration", 0.03}}},  // duration of one frame
                      {"objects", {{"model", {{"mesh", {{"file", name}}}}}}}};
  return scene.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

SimulationKind meshKind() {
  SimulationKind mesh = kindOf<MeshParameters>(
      "mesh", "A generated mesh or one from a file, that may move along keyframes and be deformed.",
      checkMesh, makeMesh);
  mesh.kind.sceneAround = sceneAroundMesh;
  return mesh;
}

}  // namespace simreel::sim

#include "sim/mesh/solids.hpp"

#include "sim/mesh/mesh.hpp"
#include "sim/mesh/parameters.hpp"

#include <memory>
#include <span>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Parameters of a mesh whose shape is fixed by its kind. It is closed and collides, except for the disc.
struct SolidParameters : MeshParameters {
  explicit SolidParameters(MeshShape fixed) {
    shape = fixed;
    collides = shape != MeshShape::disc;
    if (shape == MeshShape::box) size = glm::vec3(1);
    if (shape != MeshShape::torus) radius = 0.5F;
    if (shape == MeshShape::torus) resolution = {129, 65};
    height = 1;
  }

  /// Returns nothing, because a solid does not deform.
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override { return {}; }

  void describe(scene::Fields& f) override {
    if (shape == MeshShape::box)
      f.vector("size", size, {1e-4, 1e4}, "m", "Width, height and depth (x, y and z).");
    else
      f.number("radius", radius, {1e-4, 1e4}, "m",
               shape == MeshShape::torus ? "Distance to the middle of the tube." : "Radius.");
    if (shape == MeshShape::torus) {
      f.number("tube", tube, {1e-4, 1e4}, "m", "Radius of the tube.");
      if (tube >= radius)
        f.error("tube", fmt::format("a tube of {} m closes the hole of a torus of {} m", tube, radius));
    }
    if (shape == MeshShape::cylinder || shape == MeshShape::cone)
      f.number("height", height, {1e-4, 1e4}, "m", "Height along its y axis.");
    describePlace(f);
    if (shape != MeshShape::disc) describeCollision(f);
  }
};

template <MeshShape shape>
SimulationKind solidKind(const char* name, const char* doc) {
  SimulationKind kind = meshKind();
  kind.kind = {name, doc, [] { return std::make_unique<SolidParameters>(shape); }};
  return kind;
}

}  // namespace

std::vector<SimulationKind> solidKinds() {
  return {solidKind<MeshShape::box>("box", "A solid box that may move along keyframes."),
          solidKind<MeshShape::cylinder>("cylinder", "A solid cylinder that may move along keyframes."),
          solidKind<MeshShape::cone>("cone", "A solid cone that may move along keyframes."),
          solidKind<MeshShape::torus>("torus", "A solid ring that may move along keyframes."),
          solidKind<MeshShape::disc>("disc", "A flat disc that may move along keyframes.")};
}

}  // namespace simreel::sim

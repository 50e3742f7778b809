#include "sim/shape/shape.hpp"

#include "sim/core/kind.hpp"
#include "sim/core/moments.hpp"
#include "sim/mesh/buffers.hpp"
#include "sim/mesh/shapes.hpp"
#include "sim/ports/markers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>

namespace simreel::sim {

namespace {

Mesh drawnMesh(const ShapeParameters& parameters) {
  return parameters.shape.kind == ColliderShape::Kind::plane
             ? planeMesh(parameters.size, {2, 2})
             : capsuleMesh(parameters.shape.radius, parameters.shape.length);
}

/// Solid shape without state, moved by keyframes and drawn as a mesh.
class Shape : public Simulation {
 public:
  Shape(const scene::Object& object, const Setting& /*setting*/)
      : parameters_(parametersOf<ShapeParameters>(object)),
        material_(object.material),
        buffers_(object.name, drawnMesh(parameters_)) {}

  void step(double /*time*/, const StepWatch& /*watch*/) override {}

  [[nodiscard]] std::optional<glm::vec3> middle(double time) const override {
    return parameters_.shape.position.at(time);
  }

  [[nodiscard]] double jumpedBy(double time) const override {
    return lastJump(time, parameters_.shape.position, parameters_.shape.rotation);
  }

  void publish(double time, Drawables& drawables) const override {
    if (!parameters_.visible) return;
    Surface surface = buffers_.surface();
    surface.model = rotationMatrix(parameters_.shape.rotation.at(time));
    surface.model[3] = glm::vec4(parameters_.shape.position.at(time), 1.0F);
    surface.doubleSided = parameters_.shape.kind == ColliderShape::Kind::plane;
    surface.material = &material_;
    drawables.surfaces.push_back(surface);
  }

 private:
  ShapeParameters parameters_;
  scene::Material material_;
  MeshBuffers buffers_;
};

constexpr int tilesAcross = 8;  ///< tiles of a repeat of the texture

/// Returns a chequered texture of light and darker tiles.
std::shared_ptr<const scene::Image> chequeredTiles() {
  constexpr int texels = 32;  // side of a tile
  constexpr std::array<std::uint8_t, 2> greys = {255, 214};
  auto image = std::make_shared<scene::Image>();
  image->name = "tiles";
  image->size = glm::ivec2(tilesAcross * texels);
  for (int row = 0; row < image->size.y; ++row)
    for (int column = 0; column < image->size.x; ++column) {
      const std::uint8_t grey = greys.at(static_cast<std::size_t>((row / texels + column / texels) % 2));
      image->rgba.insert(image->rgba.end(), {grey, grey, grey, 255});
    }
  return image;
}

template <ColliderShape::Kind kind>
SimulationKind shapeKind(const char* name, const char* doc) {
  return {{name, doc, [] { return std::make_unique<ShapeParameters>(kind); }}, {}, makeSimulation<Shape>};
}

}  // namespace

std::optional<scene::Box> ShapeParameters::framed() const {
  if (!visible || shape.kind == ColliderShape::Kind::plane) return std::nullopt;
  std::optional<scene::Box> box;
  for (const double seconds : momentsOf(shape.position, shape.rotation))
    for (const float end : {-0.5F, 0.5F}) {
      const glm::vec3 along(rotationMatrix(shape.rotation.at(seconds))[1]);
      const glm::vec3 middle = shape.position.at(seconds) + along * (end * shape.length);
      scene::include(box, middle - shape.radius);
      scene::include(box, middle + shape.radius);
    }
  if (box) box->round = shape.length == 0 && !shape.position.moves();
  return box;
}

std::optional<scene::Box> ShapeParameters::framedAlone() const {
  if (!visible || shape.kind != ColliderShape::Kind::plane) return std::nullopt;
  constexpr float maximum = 3;  // maximum half width and half depth, in metres, of the part of a plane that
                                // the camera frames
  const glm::mat3 turn(rotationMatrix(shape.rotation.at(0)));
  const glm::vec3 middle = shape.position.at(0);
  const float wide = std::min(0.5F * size.x, maximum), deep = std::min(0.5F * size.z, maximum);
  std::optional<scene::Box> box;
  for (const float x : {-wide, wide})
    for (const float z : {-deep, deep}) scene::include(box, middle + turn * glm::vec3(x, 0, z));
  return box;
}

std::optional<scene::Material> ShapeParameters::look() const {
  if (!tiled) return std::nullopt;
  static const std::shared_ptr<const scene::Image> tiles = chequeredTiles();
  constexpr float tile = 0.5F;  // side of a tile in metres
  scene::Material material;
  material.roughness = 0.38F;
  material.finish.color.image = tiles;
  const auto repeats = [](float length) {
    return std::max(1.0F, std::round(length / (tile * tilesAcross)));
  };
  material.textureScale = {repeats(size.x), repeats(size.z), 1};
  return material;
}

void ShapeParameters::describe(scene::Fields& f) {
  using Kind = ColliderShape::Kind;
  tiled = shape.kind == Kind::plane && f.version() > 1;
  f.vector("position", shape.position, scene::anyNumber, "m",
           shape.kind == Kind::plane ? "A point of the plane, the middle of the drawn part." : "Centre.");
  f.vector("rotation", shape.rotation, scene::anyNumber, "degrees", "About x, then y, then z.");
  if (shape.kind != Kind::plane) f.number("radius", shape.radius, {1e-4, 1e4}, "m", "Radius.");
  if (shape.kind == Kind::capsule)
    f.number("length", shape.length, {0, 1e4}, "m",
             "Distance between the centres of the two ends, along local y.");
  if (shape.kind == Kind::plane)
    f.flatVector("size", size, {0, 1e4}, "m",
                 "Width and depth of the drawn part, as [x, z] or [x, 0, z]; it collides without end.",
                 {1, 0});
  f.boolean("collides", collides, "Makes simulations touch it.");
  f.boolean("visible", visible, "Draws it.");
  f.number("grip", shape.grip, {0, 1e6}, "1/s",
           "Rate at which sliding objects lose speed; 25.3 keeps 0.9 of it in 1/240 s.");
  f.optionalNumber("friction", shape.friction, {0, 100}, "",
                   "Coulomb's coefficient, instead of grip: objects hold on slopes up to its arc tangent.");
  if (shape.friction && f.given("grip")) f.error("friction", "give \"grip\" or \"friction\", not both");
  f.idleUnless(shape.kind != Kind::plane || visible, "visible", {"size"}, "a plane that is \"visible\"");
  f.idleUnless(collides, "collides", {"grip", "friction"}, "what \"collides\"");
}

void ShapeParameters::ports(Ports& ports) const {
  ports.provide<Touchable>(collides);
}

SimulationKind sphereKind() {
  return shapeKind<ColliderShape::Kind::sphere>("sphere", "A solid ball that may move along keyframes.");
}
SimulationKind capsuleKind() {
  return shapeKind<ColliderShape::Kind::capsule>(
      "capsule", "A solid rod with round ends that may move along keyframes.");
}
SimulationKind planeKind() {
  return shapeKind<ColliderShape::Kind::plane>("plane", "A solid plane facing its local y.");
}

}  // namespace simreel::sim

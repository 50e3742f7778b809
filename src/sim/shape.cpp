#include "sim/shape.hpp"

#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

struct Mesh {
  std::vector<glm::vec4> positions;
  std::vector<glm::vec4> normals;
  std::vector<glm::vec2> uvs;
  std::vector<unsigned> indices;
};

/// Rows of `columns` quads between rows+1 rings of columns+1 vertices, front face outwards.
void connectRings(Mesh& mesh, unsigned rows, unsigned columns) {
  for (unsigned row = 0; row < rows; ++row)
    for (unsigned column = 0; column < columns; ++column) {
      const unsigned a = row * (columns + 1) + column;
      const unsigned b = a + columns + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
}

/// A sphere cut at its equator, its halves moved apart by `length` along y.
Mesh capsuleMesh(float radius, float length) {
  constexpr unsigned columns = 64;
  constexpr unsigned half = 16;  // rings of a hemisphere
  Mesh mesh;
  for (unsigned ring = 0; ring < 2 * (half + 1); ++ring) {
    const bool lower = ring > half;
    const unsigned step = lower ? ring - 1 : ring;
    const double polar = std::numbers::pi * step / (2.0 * half);
    const double y = std::cos(polar);
    for (unsigned column = 0; column <= columns; ++column) {
      const double turn = 2.0 * std::numbers::pi * column / columns;
      const glm::vec3 normal(static_cast<float>(std::sin(polar) * std::sin(turn)), static_cast<float>(y),
                             static_cast<float>(std::sin(polar) * std::cos(turn)));
      glm::vec3 position = normal * radius;
      position.y += lower ? -0.5F * length : 0.5F * length;
      mesh.positions.emplace_back(position, 1.0F);
      mesh.normals.emplace_back(normal, 0.0F);
      mesh.uvs.emplace_back(static_cast<float>(column) / columns, static_cast<float>(step) / (2.0F * half));
    }
  }
  connectRings(mesh, 2 * half + 1, columns);
  return mesh;
}

Mesh planeMesh(const glm::vec3& size) {
  Mesh mesh;
  for (int z = 0; z < 2; ++z)
    for (int x = 0; x < 2; ++x) {
      const auto u = static_cast<float>(x);
      const auto v = static_cast<float>(z);
      mesh.positions.emplace_back((u - 0.5F) * size.x, 0.0F, (v - 0.5F) * size.z, 1.0F);
      mesh.normals.emplace_back(0, 1, 0, 0);
      mesh.uvs.emplace_back(u, v);
    }
  mesh.indices = {0, 2, 1, 1, 2, 3};
  return mesh;
}

/// Solid scenery: no state, moved by keyframes, drawn as a mesh.
class Shape : public Simulation {
 public:
  Shape(const scene::Object& object, const ShapeParameters& parameters)
      : parameters_(parameters), material_(object.material) {
    const bool plane = parameters.shape.kind == ColliderShape::Kind::plane;
    const Mesh mesh =
        plane ? planeMesh(parameters.size) : capsuleMesh(parameters.shape.radius, parameters.shape.length);
    positions_ = gl::Buffer::of<glm::vec4>(object.name + " positions", mesh.positions);
    normals_ = gl::Buffer::of<glm::vec4>(object.name + " normals", mesh.normals);
    uvs_ = gl::Buffer::of<glm::vec2>(object.name + " uvs", mesh.uvs);
    indices_ = gl::Buffer::of<unsigned>(object.name + " indices", mesh.indices);
    positionView_ = gl::Texture::view(object.name + " positions", GL_RGBA32F, positions_);
    normalView_ = gl::Texture::view(object.name + " normals", GL_RGBA32F, normals_);
    uvView_ = gl::Texture::view(object.name + " uvs", GL_RG32F, uvs_, sizeof(glm::vec2));
    vertexCount_ = static_cast<int>(mesh.positions.size());
    indexCount_ = static_cast<int>(mesh.indices.size());
  }

  void step(double /*time*/, const StepWatch& /*watch*/) override {}

  void publish(double time, Drawables& drawables) const override {
    if (!parameters_.visible) return;
    Surface surface;
    surface.positions = &positionView_;
    surface.normals = &normalView_;
    surface.uvs = &uvView_;
    surface.vertexCount = vertexCount_;
    surface.indices = &indices_;
    surface.indexCount = indexCount_;
    surface.model = rotationMatrix(parameters_.shape.rotation.at(time));
    surface.model[3] = glm::vec4(parameters_.shape.position.at(time), 1.0F);
    surface.doubleSided = parameters_.shape.kind == ColliderShape::Kind::plane;
    surface.material = &material_;
    drawables.surfaces.push_back(surface);
  }

 private:
  ShapeParameters parameters_;
  scene::Material material_;
  gl::Buffer positions_, normals_, uvs_, indices_;
  gl::Texture positionView_, normalView_, uvView_;
  int vertexCount_ = 0;
  int indexCount_ = 0;
};

template <ColliderShape::Kind kind>
SimulationKind shapeKind(const char* name, const char* doc) {
  return {{name, doc, [] { return std::make_unique<ShapeParameters>(kind); }},
          [](const scene::Object& object, const Setting&) -> std::unique_ptr<Simulation> {
            return std::make_unique<Shape>(object,
                                           dynamic_cast<const ShapeParameters&>(*object.parameters));
          }};
}

}  // namespace

void ShapeParameters::describe(scene::Fields& f) {
  using Kind = ColliderShape::Kind;
  f.vector("position", shape.position, scene::anyNumber, "m",
           shape.kind == Kind::plane ? "A point of the plane, the middle of the drawn part." : "Centre.");
  f.vector("rotation", shape.rotation, scene::anyNumber, "degrees", "About x, then y, then z.");
  if (shape.kind != Kind::plane) f.number("radius", shape.radius, {1e-4, 1e4}, "m", "Radius.");
  if (shape.kind == Kind::capsule)
    f.number("length", shape.length, {0, 1e4}, "m",
             "Distance between the centres of the two ends, along local y.");
  if (shape.kind == Kind::plane)
    f.vector("size", size, {0, 1e4}, "m",
             "Width and depth of the drawn part (x and z); it collides without end.");
  f.boolean("collides", collides, "Whether simulations touch it.");
  f.boolean("visible", visible, "Whether it is drawn.");
  f.number("grip", shape.grip, {0, 1e6}, "1/s",
           "Rate at which cloth sliding over it loses speed; 25.3 keeps 0.9 at 240 Hz.");
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

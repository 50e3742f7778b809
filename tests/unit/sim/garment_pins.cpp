// Tests pins and seams of cloth meshes: pins by number, position and image, seams, and errors in scenes.
#include "base/error.hpp"
#include "reference/garment_twin.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/core/kind.hpp"
#include "sim/world/list.hpp"
#include "source_folder.hpp"
#include "unit/help.hpp"
#include "unit/sim/garment_help.hpp"

#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

/// Returns a plane of 1 x 1 m with 11 x 11 vertices.
sim::ClothParameters unitPlane() {
  sim::ClothParameters p = test::freeCloth();
  p.mesh->size = glm::vec3(1, 0, 1);
  p.mesh->resolution = {11, 11};
  return p;
}

std::set<std::size_t> pinnedVertices(const sim::ClothParameters& p) {
  const sim::GarmentPlan plan("sheet", p, 1, 1.0 / 60, {});
  std::set<std::size_t> found;
  const auto positions = plan.firstPositions();
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (positions[i].w == 0) found.insert(i);
  return found;
}

std::string refusedPins(const sim::ClothParameters& p) {
  try {
    static_cast<void>(pinnedVertices(p));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("garment: pins are selected by vertex, by a box in world space and by a picture over uv") {
  sim::ClothParameters p = unitPlane();
  p.pins.emplace_back().vertices = {3, 120, 3};
  CHECK(pinnedVertices(p) == std::set<std::size_t>{3, 120});
  p.pins.clear();
  p.position = glm::vec3(5, 0, 0);
  test::pinBox(p, glm::vec3(4.45F, -1, 0.35F), glm::vec3(4.65F, 1, 0.6F));
  CHECK(pinnedVertices(p) == std::set<std::size_t>{9 * 11, 9 * 11 + 1, 10 * 11, 10 * 11 + 1});
  p.pins.clear();
  // The image has two rows of two pixels. Only the lower right pixel is bright.
  const test::TemporaryFile map("pins.pgm",
                                std::string("P5 2 2 255\n") + '\x10' + '\x7f' + '\x20' + '\xff');
  p.pins.emplace_back().map = map.path();
  std::set<std::size_t> expected;
  // Vertex 10 (uv 1) is not pinned: the image repeats, so uv 1 reads the first pixel.
  for (std::size_t z = 5; z < 10; ++z)
    for (std::size_t x = 5; x < 10; ++x) expected.insert(z * 11 + x);
  CHECK(pinnedVertices(p) == expected);
}

TEST_CASE("garment: pins and seams without vertices are refused") {
  sim::ClothParameters p = unitPlane();
  p.pins.emplace_back().vertices = {121};
  test::checkHas(refusedPins(p),
                 "cloth \"sheet\" (plane): pins[0] names vertex 121, but there are 121 (0 to 120)");
  p.pins.clear();
  test::pinBox(p, glm::vec3(2), glm::vec3(3));
  test::checkHas(refusedPins(p), "pins[0] holds no vertex");
  p.pins[0].box = sim::PinBox{glm::vec3(-0.01F), glm::vec3(0.01F)};
  p.pins[0].clamp = true;
  test::checkHas(refusedPins(p), "pins[0] has \"clamp\", but holds no edge of a border");
  p.pins.clear();
  p.seams.push_back({{0}, {500}, 1});
  test::checkHas(refusedPins(p), "seams[0] names vertex 500");
  p.seams.clear();
  p.mesh->shape = sim::ClothShape::file;
  const test::TemporaryFile file("bare.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nf 1 2 3\n");
  p.mesh->file = file.path();
  p.pins.emplace_back().map = "nothing.png";
  test::checkHas(refusedPins(p), "has no uv");
  p.pins[0].map.clear();
  p.pins[0].vertices = {0};
  CHECK(refusedPins(p).empty());  // Pins of a mesh with a single face are accepted.
}

TEST_CASE("garment: a seam closes two pieces in its time without moving their centre of mass") {
  // The mesh consists of two rectangles of 6 x 4 cells, 0.1 m apart.
  sim::Mesh mesh = test::rectangle(test::Kind::random, {6, 4}, 0.05);
  sim::Mesh other = test::rectangle(test::Kind::equilateral, {6, 4}, 0.05);
  const auto first = static_cast<unsigned>(mesh.positions.size());
  for (glm::vec3 p : other.positions) mesh.positions.push_back(p + glm::vec3(0.4F, 0.02F, 0));
  mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
  for (const unsigned i : other.indices) mesh.indices.push_back(i + first);
  const test::TemporaryFile file("pieces.obj", test::objOf(mesh));
  sim::ClothParameters p = test::freeCloth();
  p.mesh->shape = sim::ClothShape::file;
  p.mesh->file = file.path();
  p.damping = 3;
  const sim::Mesh read = p.mesh->make();
  sim::Seam seam;
  seam.seconds = 0.5;
  // Vertices are compared by position, because readers may reorder them.
  for (int i = 0; i < static_cast<int>(read.positions.size()); ++i)
    for (int j = 0; j < static_cast<int>(read.positions.size()); ++j) {
      const glm::vec3 a = read.positions[static_cast<std::size_t>(i)];
      const glm::vec3 b = read.positions[static_cast<std::size_t>(j)];
      if (std::abs(a.x - 0.15F) < 1e-4F && std::abs(b.x - 0.25F) < 1e-4F && std::abs(a.z - b.z) < 0.025F) {
        seam.from.push_back(i);
        seam.to.push_back(j);
      }
    }
  REQUIRE(seam.from.size() == 5);
  p.seams.push_back(seam);
  GarmentTwin twin(sim::GarmentPlan("pieces", p, 1, 1.0 / 60, {}));
  const auto centre = [&] {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < twin.positions.size(); ++i)
      sum += glm::dvec3(twin.positions[i]) * twin.plan().masses()[i];
    return sum;
  };
  const auto widest = [&] {
    double maximum = 0;
    for (const glm::uvec4& stitch : twin.plan().arrays().stitches)
      maximum = std::max(maximum, static_cast<double>(glm::distance(glm::vec3(twin.positions[stitch.x]),
                                                                    glm::vec3(twin.positions[stitch.y]))));
    return maximum;
  };
  const glm::dvec3 before = centre();
  CHECK(widest() > 0.1);
  for (int frame = 0; frame < 15; ++frame) twin.step(frame / 60.0);
  CHECK(widest() == doctest::Approx(0.0525).epsilon(0.1).scale(0));
  for (int frame = 15; frame < 120; ++frame) twin.step(frame / 60.0);
  CHECK(widest() < 1e-4);
  CHECK(glm::distance(centre(), before) < 1e-6);
}

TEST_CASE("garment: scene parameters of garments are read, and errors are named") {
  const auto mistakes = [](const std::string& parameters) -> std::string {
    const std::string text = R"({"version": 1, "objects": {"sheet": {"cloth": )" + parameters + "}}}";
    try {
      const auto scene = scene::parseScene(text, sourceFolder() + "/assets/sheet.json", {}, sim::kinds());
      const auto& p = sim::parametersOf<sim::ClothParameters>(scene.objects.front());
      CHECK(p.mesh.has_value());
      CHECK(p.fabric.has_value());
      CHECK(!p.substeps);
      CHECK(p.pins.empty());
      CHECK(p.wind.at(0) == glm::vec3(0));
    } catch (const UserError& error) {
      CHECK(error.code() == ExitCode::usage);
      return error.what();
    }
    return "";
  };
  CHECK(mistakes(R"({"mesh": {"shape": "disc"}})").empty());
  CHECK(mistakes(R"({"mesh": {"file": "meshes/shield.obj"}, "fabric": {"material": "silk"}})").empty());
  const auto has = [&](const char* parameters, const char* part) {
    test::checkHas(mistakes(parameters), part);
  };
  has(R"({"mesh": {"shape": "file"}})", "the mesh to read");
  has(R"({"mesh": {"shape": "disc", "file": "meshes/shield.obj"}})", "leave it out");
  has(R"({"mesh": {}, "size": [3, 3]})", "leave out \"size\"");
  has(R"({"mesh": {}, "stiffness": 3})", "leave out \"stiffness\"");
  has(R"({"mesh": {}, "pins": [{"rows": [0]}]})", "a mesh has no rows");
  has(R"({"pins": [{"vertices": [0]}]})", "this pins a mesh");
  has(R"({"mesh": {}, "pins": [{"box": {"min": [0, 1, 0], "max": [1, 0, 1]}}]})", "below the least");
  has(R"({"mesh": {}, "seams": [{"from": [1, 2], "to": [3]}]})", "2 vertices are sewn to 1");
  has(R"({"seams": [{"from": [1], "to": [3]}]})", "a grid has no seams");
  has(R"({"mesh": {"shape": "torus", "radius": 0.2}})", "closes the hole");
}

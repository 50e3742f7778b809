// Tests equations on meshes by comparison with theory. A sphere's harmonics must decay at a rate
// proportional to l (l + 1), a grid of right triangles must have the five-point Laplacian, diffusion must
// conserve the sum, and seams must have no effect.
#include "base/error.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/mesh/shapes.hpp"
#include "sim/mesh_cells/cells.hpp"
#include "sim/reaction/plan.hpp"
#include "sim/reaction/presets.hpp"
#include "sim/world/list.hpp"
#include "source_folder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

std::string meshScene(const std::string& members) {
  return "{\"version\": 1, \"objects\": {\"r\": {\"reaction\": {" + members + "}}}}";
}

sim::ReactionParameters meshRule(const std::string& members) {
  const auto scene = scene::parseScene(meshScene(members), "s.json", {}, sim::kinds());
  return dynamic_cast<const sim::ReactionParameters&>(*scene.objects.at(0).parameters);
}

struct OnMesh {
  OnMesh(const std::string& members, int steps)
      : plan(meshRule(members), "r", 1, 1.0), field(plan.firstField()) {
    for (int i = 0; i < steps; ++i) sim::evaluateStep(plan, plan.valuesAt(0), i, 0, field);
  }
  /// Returns the sum over all cells of area times the product of two species.
  [[nodiscard]] double product(std::size_t a, std::size_t b) const {
    double sum = 0;
    for (std::size_t i = 0; i < plan.cells().areas.size(); ++i)
      sum += plan.cells().areas[i] * static_cast<double>(field.stage[a][i]) *
             static_cast<double>(field.stage[b][i]);
    return sum;
  }
  [[nodiscard]] double total(std::size_t a) const {
    double sum = 0;
    for (std::size_t i = 0; i < plan.cells().areas.size(); ++i)
      sum += plan.cells().areas[i] * static_cast<double>(field.stage[a][i]);
    return sum;
  }
  sim::ReactionPlan plan;
  sim::RuleField field;
};

std::string meshRefusal(const std::string& members) {
  try {
    const sim::ReactionPlan plan(meshRule(members), "r", 1, 1.0);
    return "none";
  } catch (const UserError& error) {
    return error.what();
  }
}

const std::string ballMesh =
    R"X("mesh": {"shape": "sphere", "radius": 1.7, "resolution": [81, 41]}, "spacing": 1, )X";
/// Expressions of the Legendre polynomials of c, the height above the equator divided by the radius.
const std::string harmonics[] = {"", "c", "1.5*c^2 - 0.5", "2.5*c^3 - 1.5*c",
                                 "4.375*c^4 - 3.75*c^2 + 0.375"};

std::string harmonicStart(int l) {
  std::string text;
  for (const char letter : harmonics[static_cast<std::size_t>(l)])
    text += letter == 'c' ? std::string("(2*y/height - 1)") : std::string(1, letter);
  return text;
}

}  // namespace

TEST_CASE(
    "reaction on a sphere: spherical harmonics are eigenfunctions of the Laplacian with eigenvalues l (l + "
    "1)") {
  for (int l = 1; l <= 4; ++l) {
    CAPTURE(l);
    const OnMesh made(
        ballMesh +
            fmt::format(
                R"X("dt": 1, "species": {{"u": {{"start": "{}"}}, "w": {{"rate": "laplacian(u)"}}}})X",
                harmonicStart(l)),
        1);
    const double radius =
        1.7 / made.plan.cells().meanEdge;  // The radius is scaled, because the spacing of the cells is 1.
    const double found = -made.product(0, 1) / made.product(0, 0) * radius * radius;
    CHECK_MESSAGE(std::abs(found / (l * (l + 1)) - 1) < 0.02, (found));
    // The second check tests the function itself, not only its mean.
    CHECK(made.product(1, 1) * std::pow(radius, 4) / made.product(0, 0) ==
          doctest::Approx(std::pow(l * (l + 1), 2)).epsilon(0.05));
  }
}

TEST_CASE("reaction on a sphere: heat decays like its harmonics and its sum is conserved") {
  for (const int l : {1, 2, 3}) {
    CAPTURE(l);
    const std::string rule =
        R"X("mesh": {"shape": "sphere", "radius": 1.7, "resolution": [61, 31]}, "spacing": 1, )X" +
        fmt::format(R"X("dt": 0.005, "species": {{"u": {{"diffusion": 1, "start": "1 + {}"}}}})X",
                    harmonicStart(l));
    const OnMesh begin(rule, 0), end(rule, 1500);
    const double radius = 1.7 / begin.plan.cells().meanEdge, mean = begin.total(0) * begin.total(0);
    double area = 0;
    for (const double one : begin.plan.cells().areas) area += one;
    CHECK(area == doctest::Approx(4 * std::numbers::pi * 1.7 * 1.7).epsilon(0.02));
    CHECK(end.total(0) == doctest::Approx(begin.total(0)).epsilon(1e-5));
    const double kept = (end.product(0, 0) - mean / area) / (begin.product(0, 0) - mean / area);
    const double rate = -std::log(kept) / 2 / (1500 * 0.005) * radius * radius;
    CHECK_MESSAGE(std::abs(rate / (l * (l + 1)) - 1) < 0.02, (rate));
  }
}

TEST_CASE("reaction on a grid of right triangles uses the five-point stencil") {
  const OnMesh made(
      R"X("mesh": {"shape": "plane", "size": [8, 0, 6], "resolution": [17, 13]}, "spacing": 1, "dt": 1,
    "species": {"u": {"start": "sin(0.8*x)*cos(0.6*z) + 0.1*x"}, "w": {"rate": "laplacian(u)"}})X",
      1);
  const sim::MeshCells& cells = made.plan.cells();
  REQUIRE(cells.count() == 17 * 13);
  const auto at = [&](int x, int z) {  // The cell is found by position, because cells are numbered in the
                                       // order of the faces.
    for (std::size_t i = 0; i < cells.places.size(); ++i)
      if (std::abs(cells.places[i].x + 4 - 0.5 * x) < 1e-6 &&
          std::abs(cells.places[i].z + 3 - 0.5 * z) < 1e-6)
        return i;
    return cells.places.size();
  };
  // The mean edge of this mesh is longer than the sides of its squares.
  const double side = 0.5 / cells.meanEdge;
  for (int z = 1; z < 12; ++z)
    for (int x = 1; x < 16; ++x) {
      const auto u = [&](int dx, int dz) {
        return static_cast<double>(made.field.stage[0][at(x + dx, z + dz)]);
      };
      const double want = (u(-1, 0) + u(1, 0) + u(0, -1) + u(0, 1) - 4 * u(0, 0)) / (side * side);
      CHECK(static_cast<double>(made.field.stage[1][at(x, z)]) == doctest::Approx(want).epsilon(1e-4));
    }
}

TEST_CASE(
    "reaction on meshes conserves diffusing substances, also on open meshes, and keeps uniform states") {
  for (const char* mesh :
       {R"X({"shape": "torus", "radius": 1, "tube": 0.4, "resolution": [41, 21]})X",
        R"X({"shape": "plane", "size": [3, 0, 2], "resolution": [23, 17], "refine": 1})X",
        R"X({"shape": "sphere", "resolution": [17, 9], "refine": 2})X"}) {
    CAPTURE(std::string(mesh));
    const std::string rule =
        fmt::format(R"X("mesh": {}, "dt": 0.02, "parameters": {{"d": {{"value": 0.5, "across": 1}}}},
      "species": {{"u": {{"diffusion": 1, "start": "1 + random(1)"}}, "v": {{"start": "1 + random(2)", "rate": "diffuse(d, v)"}},
                   "even": {{"diffusion": 1, "start": "0.7"}}}})X",
                    mesh);
    const OnMesh begin(rule, 0), end(rule, 200);
    for (const std::size_t species : {0, 1})
      CHECK(end.total(species) == doctest::Approx(begin.total(species)).epsilon(3e-6));
    CHECK(end.product(0, 0) < 0.95 * begin.product(0, 0));
    for (const float value : end.field.stage[2]) CHECK(value == 0.7F);
  }
}

TEST_CASE("reaction on meshes: presets are as stable as on a grid, with or without poles") {
  for (const char* mesh : {R"X({"shape": "sphere", "resolution": [17, 9]})X",
                           R"X({"shape": "torus", "resolution": [33, 13]})X",
                           R"X({"shape": "plane", "size": [4, 0, 1], "resolution": [21, 17]})X"})
    for (const sim::ReactionPreset& preset : sim::reactionPresets()) {
      if (std::string(preset.name) == "kuramotoSivashinsky")
        continue;  // Rules with gradients are skipped, because gradients do not exist on meshes.
      CAPTURE(std::string(mesh));
      CAPTURE(std::string(preset.name));
      const OnMesh made(fmt::format(R"X("preset": "{}", "mesh": {})X", preset.name, mesh), 150);
      for (const auto& stage : made.field.stage)
        for (const float value : stage) REQUIRE(std::abs(value) < 100);
    }
}

TEST_CASE("reaction on a sphere: cells have nearly equal area") {
  const OnMesh made(R"X("preset": "heat", "mesh": {"shape": "sphere", "resolution": [30, 20]})X", 0);
  const std::vector<double>& areas = made.plan.cells().areas;
  CHECK(areas.size() == 642);
  const auto [minimum, maximum] = std::minmax_element(areas.begin(), areas.end());
  CHECK(*maximum < 2.5 * *minimum);
  for (const glm::dvec3& place : made.plan.cells().places)
    CHECK(glm::length(place) == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("mesh cells: seams are merged, and Loop subdivision makes four faces of each and keeps borders") {
  const sim::Mesh ball = sim::sphereMesh(1, {33, 17});
  CHECK(sim::cellsOf(ball, "it").count() == 32 * 15 + 2);
  const sim::Mesh finer = sim::refined(ball);
  CHECK(finer.indices.size() == 4 * 3 * std::size_t{32 * 14 * 2 + 2 * 32});
  // For a closed surface, Euler's formula is V - E + F = 2, with V vertices, E edges and F faces.
  const sim::MeshCells cells = sim::cellsOf(finer, "it");
  CHECK(cells.count() - static_cast<int>(cells.links.size()) / 2 +
            static_cast<int>(finer.indices.size()) / 3 ==
        2);
  // A flat sheet and its border must stay flat.
  const sim::Mesh sheet = sim::refined(sim::planeMesh({4, 0, 2}, {5, 4}));
  double maximum = 0;
  for (const glm::vec3& place : sheet.positions) {
    CHECK(place.y == 0);
    maximum = std::max(maximum, static_cast<double>(std::abs(place.z)));
  }
  CHECK(maximum == doctest::Approx(1));
  for (const glm::vec3& normal : sheet.normals) CHECK(normal.y == 1);
}

TEST_CASE(
    "pictures are mapped to meshes by texture coordinates, by longitude and latitude, or over the bounding "
    "box") {
  const std::string gingham = "\"" + sourceFolder() + "/assets/textures/gingham.png\"";
  const sim::Picture picture =
      sim::loadPicture(sourceFolder() + "/assets/textures/gingham.png", "test picture", 4096);
  const auto mapped = [&](const std::string& mesh) {
    return OnMesh(
        fmt::format(R"X("mesh": {}, "parameters": {{"f": {{"value": 2, "image": {}, "white": 5}}}},
      "species": {{"u": {{"start": "f"}}}})X",
                    mesh, gingham),
        0);
  };
  /// Interpolates bilinearly between pixel centres, in double precision.
  const auto level = [&](double u, double v) {
    const auto between = [](double at, int count) {
      const double place = std::clamp(at * count - 0.5, 0.0, count - 1.0);
      const int before = std::min(static_cast<int>(place), count - 2);
      return std::pair(before, place - before);
    };
    const auto [x, right] = between(u, picture.size.x);
    const auto [y, down] = between(v, picture.size.y);
    return std::lerp(std::lerp(double(picture.level(x, y)), double(picture.level(x + 1, y)), right),
                     std::lerp(double(picture.level(x, y + 1)), double(picture.level(x + 1, y + 1)), right),
                     down);
  };
  const auto holds = [&](const OnMesh& made, const auto& place) {
    double spread = 0;
    for (std::size_t i = 0; i < made.field.stage[0].size(); ++i) {
      const glm::dvec2 uv = place(made.plan.cells().places[i]);
      // A position in an image is accurate to 1/65536.
      const double want = 2 + 3 * level(uv.x, uv.y) / 255,
                   got = static_cast<double>(made.field.stage[0][i]);
      CHECK(std::abs(got - want) < 3.0 * picture.size.x / 65536);
      spread = std::max(spread, std::abs(got - static_cast<double>(made.field.stage[0][0])));
    }
    CHECK(spread > 1);
  };
  const std::string sheet = R"X({"shape": "plane", "size": [3, 0, 2], "resolution": [24, 19])X";
  const auto above = [](const glm::dvec3& p) { return glm::dvec2(p.x / 3 + 0.5, p.z / 2 + 0.5); };
  holds(mapped(sheet + "}"), above);
  holds(mapped(sheet + R"X(, "maps": "top"})X"), above);
  // A subdivided sheet has no texture coordinates, and seen from the front it would be a line. It is
  // therefore mapped from the top.
  holds(mapped(sheet + R"X(, "refine": 1, "maps": "top"})X"), above);
  holds(mapped(R"X({"shape": "sphere", "radius": 2, "resolution": [33, 17], "maps": "front"})X"),
        [](const glm::dvec3& p) { return glm::dvec2(p.x / 4 + 0.5, 0.5 - p.y / 4); });
  holds(mapped(R"X({"shape": "sphere", "resolution": [33, 17]})X"), [](const glm::dvec3& p) {
    const double turn = std::atan2(p.x, p.z) / (2 * std::numbers::pi);
    return glm::dvec2(turn < 0 ? turn + 1 : turn, std::acos(p.y) / std::numbers::pi);
  });
  CHECK(meshRefusal(R"X("preset": "heat", "mesh": {"shape": "plane", "refine": 1, "maps": "texture"})X")
            .find("no texture coordinates, for \"refine\" closes its seams") != std::string::npos);
}

TEST_CASE("reaction on a mesh: errors are reported in one line") {
  const auto says = [](const std::string& refused, const char* what) {
    const bool right = refused.find(what) != std::string::npos;
    if (!right) MESSAGE(refused);
    return right;
  };
  const std::string heat = "\"preset\": \"heat\", ";
  CHECK(says(meshRefusal(heat + R"X("mesh": {"shape": "file"})X"), "needs \"file\""));
  CHECK(says(meshRefusal(heat + R"X("mesh": {"shape": "sphere"}, "size": [8, 8])X"),
             "\"size\" is for a grid"));
  CHECK(says(meshRefusal(heat + R"X("mesh": {"shape": "plane", "size": [0, 0, 0]})X"),
             "no face with an area"));
  CHECK(says(meshRefusal(ballMesh + R"X("species": {"u": {"rate": "ddx(u)"}})X"),
             "a mesh has no rows of cells"));
  CHECK(says(meshRefusal(ballMesh + R"X("species": {"u": {"rate": "q"}})X"), "unknown name \"q\""));
  CHECK(says(meshRefusal(heat + R"X("mesh": {"shape": "sphere", "resolution": [2049, 513], "refine": 2})X"),
             "at most 8000000 are allowed"));
  CHECK(meshRefusal(ballMesh + R"X("species": {"u": {"rate": "laplacian(u) + z - depth"}})X") == "none");
}

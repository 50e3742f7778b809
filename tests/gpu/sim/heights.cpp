// Tests cloth and particles that fall onto a deformed mesh, and water that flows over it. They must equal
// their CPU twins word by word and stay above the surface.
#include "gpu/context.hpp"
#include "gpu/sim/words.hpp"
#include "reference/cloth_twin.hpp"
#include "reference/garment_twin.hpp"
#include "reference/particles_twin.hpp"
#include "reference/water_twin.hpp"
#include "scene/load.hpp"
#include "sim/mesh/deform_cpu.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

constexpr double heightsFrame = 1.0 / 60.0;

const char* const swell = R"("shape": "plane", "size": [5, 0, 4], "resolution": [67, 51], "collides": true,
  "position": [0.3, -0.2, 0.1],
  "deform": [{"waves": [{"direction": 33, "length": 1.3, "amplitude": 0.09, "steepness": 0.7}]},
             {"ripple": {"amplitude": 0.08, "wavelength": 1.7, "speed": 6}},
             {"push": {"softness": 0.2}}])";

/// Returns a scene with an object that falls onto a deformed mesh. The object precedes the mesh in the
/// scene, so that the test fails if the objects step in this order.
scene::Scene sceneOf(const std::string& falling, const std::string& technique = "compute",
                     double preroll = 0) {
  return scene::parseScene(fmt::format(R"({{"version": 1, "seed": 5, "time": {{"start": {3}}}, "objects": {{
        "faller": {{{0}}}, "swell": {{"mesh": {{{1}, "technique": "{2}"}}}},
        "ball": {{"sphere": {{"radius": 0.3, "position": [0.4, -0.1, 0.2], "collides": true}}}}}}}})",
                                       falling, swell, technique, preroll),
                           "test.json", {}, sim::kinds());
}

/// Computes the heights of each frame on the CPU, in the layout that the kernels read.
class HeightsTwin {
 public:
  explicit HeightsTwin(const scene::Scene& scene)
      : mesh(dynamic_cast<const sim::MeshParameters&>(*scene.objects.at(1).parameters)),
        plan(mesh, heightsFrame),
        shape_(mesh.make(1)),
        deform_("swell", mesh, shape_, colliders()),
        rest_("swell", shape_),
        cpu_(rest_, deform_.trailCells()) {}

  static std::vector<sim::ColliderShape> colliders() {
    sim::ColliderShape ball;
    ball.radius = 0.3F;
    ball.position = glm::vec3(0.4F, -0.1F, 0.2F);
    return {ball};
  }

  std::vector<glm::vec4> frame(double time) {
    std::vector<glm::vec4> heights(shape_.positions.size(), glm::vec4(0));
    for (int end = 0; end < 2; ++end) {
      cpu_.displace(deform_.at(end == 0 ? time : time + heightsFrame), sim::Threads::all);
      for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i][end] = cpu_.positions()[i].y + plan.lift();
    }
    return heights;
  }

  /// Returns the height of the surface at the frame's end, computed independently in double precision.
  /// Returns -1e9 outside the mesh.
  [[nodiscard]] double heightAt(const std::vector<glm::vec4>& heights, const glm::vec4& p) const {
    const glm::dvec2 corner(0.3 - 2.5, 0.1 - 2.0);
    const glm::ivec2 size = plan.size();
    const double x = (p.x - corner.x) / 5.0 * (size.x - 1);
    const double z = (p.z - corner.y) / 4.0 * (size.y - 1);
    if (x < 0 || z < 0 || x > size.x - 1 || z > size.y - 1) return -1e9;
    const int column = std::min(static_cast<int>(x), size.x - 2);
    const int row = std::min(static_cast<int>(z), size.y - 2);
    const double u = x - column;
    const double v = z - row;
    const auto at = [&](int dx, int dz) -> double {
      return heights[static_cast<std::size_t>((row + dz) * size.x + column + dx)].y;
    };
    return (1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) + v * ((1 - u) * at(0, 1) + u * at(1, 1));
  }

  sim::MeshParameters mesh;
  sim::HeightPlan plan;

 private:
  sim::Mesh shape_;
  sim::DeformPlan deform_;
  sim::RestMesh rest_;
  sim::DeformCpu cpu_;
};

struct Clearance {
  double min = 1e9;  ///< minimum height above the surface in metres, over all particles and frames
  int touching = 0;  ///< number of particles that are within 1 mm of the margin in the last frame
};

/// Steps the world and the CPU twin and compares every word of every frame. Returns the distance between
/// particles and surface.
template <class Twin>
Clearance fall(const scene::Scene& scene, Twin& twin, int frames, double margin, double preroll = 0) {
  testContext();
  sim::World world(scene);
  HeightsTwin heights(scene);
  twin.heightPlan = heights.plan;
  Clearance clearance;
  for (int frame = 1; frame <= frames; ++frame) {
    const double before = (frame - 1) / 60.0 - preroll;
    world.advanceTo(frame - static_cast<int>(preroll * 60 + 0.5));
    twin.heights = heights.frame(before);
    twin.step(before);
    const auto state = world.object(0).state();
    REQUIRE(wordsUnlike(*state[0].buffer, twin.positions) == 0);
    REQUIRE(wordsUnlike(*state[1].buffer, twin.velocities) == 0);
    clearance.touching = 0;
    for (const glm::vec4& p : twin.positions) {
      const double over = p.y - heights.heightAt(twin.heights, p);
      clearance.min = std::min(clearance.min, over);
      clearance.touching += over < margin + 1e-3 ? 1 : 0;
    }
  }
  return clearance;
}

ClothTwin clothTwin(const scene::Scene& scene) {
  return ClothTwin(
      sim::ClothPlan(dynamic_cast<const sim::ClothParameters&>(*scene.objects.at(0).parameters), 5,
                     heightsFrame, HeightsTwin::colliders()));
}

ParticlesTwin particlesTwin(const scene::Scene& scene) {
  return ParticlesTwin(
      sim::ParticlePlan(dynamic_cast<const sim::ParticleParameters&>(*scene.objects.at(0).parameters), 5,
                        heightsFrame, 1 << 24, HeightsTwin::colliders()));
}

// A third of the sheet extends beyond the mesh's edge.
const char* const fallingSheet =
    R"("cloth": {"size": [35, 23], "spacing": 0.08, "position": [1.8, 0.25, 0.1],
  "rotation": [4, 20, 0], "mass": 0.004, "stiffness": 60, "margin": 0.02, "wind": [0, 0, 0], "pins": [], "substeps": 5 SOLVER})";

std::string sheetWith(const std::string& more) {
  std::string text = fallingSheet;
  return text.replace(text.find(" SOLVER"), 7, more);
}

const char* const grains =
    R"("particles": {"method": "none", "collides": true, "bounce": 0.4, "margin": 0.05,
  "acceleration": [0, -9.81, 0], "substeps": 3,
  "groups": [{"shape": "cube", "count": 333, "radius": 1.1, "position": [1.1, 1.4, 0.2], "speed": 0.5}],
  "emitters": [{"rate": 200, "position": [-1, 0.6, 0], "lifetime": 0.7, "velocity": [0, -2, 0]}]})";

}  // namespace

TEST_CASE("heights: cloth on a deforming mesh equals its CPU twin and stays above it") {
  for (const char* solver : {"", R"(, "solver": "constraints", "compliance": 1e-5)"}) {
    CAPTURE(solver);
    const auto scene = sceneOf(sheetWith(solver));
    ClothTwin twin = clothTwin(scene);
    const Clearance c = fall(scene, twin, 60, 0.02);
    CHECK(c.min > 0.02 - 1e-5);  // Results in float and double precision differ by up to 1e-5.
    CHECK(c.touching > 40);
  }
}

TEST_CASE("heights: mesh cloth on a deforming mesh equals its CPU twin and stays above it") {
  const auto scene = sceneOf(
      R"("cloth": {"mesh": {"shape": "disc", "radius": 1, "resolution": [25, 3]}, "position": [1.8, 0.25, 0.1],
  "rotation": [4, 20, 0], "fabric": {"material": "canvas", "thickness": 0}, "margin": 0.02})");
  GarmentTwin twin(
      sim::GarmentPlan("sheet", dynamic_cast<const sim::ClothParameters&>(*scene.objects.at(0).parameters),
                       5, heightsFrame, HeightsTwin::colliders()));
  const Clearance c = fall(scene, twin, 60, 0.02);
  CHECK(c.min > 0.02 - 1e-5);
  CHECK(c.touching > 50);
}

TEST_CASE("heights: particles on a deforming mesh equal their CPU twin and stay above it") {
  for (const char* method : {"none", "all-pairs"}) {
    CAPTURE(method);
    std::string text = grains;
    text.replace(text.find("none"), 4, method);
    const auto scene = sceneOf(text);
    ParticlesTwin twin = particlesTwin(scene);
    testContext();
    sim::World world(scene);
    HeightsTwin heights(scene);
    twin.heightPlan = heights.plan;
    double min = 1e9;
    int touching = 0;
    for (int frame = 1; frame <= 70; ++frame) {
      const double before = (frame - 1) / 60.0;
      world.advanceTo(frame);
      twin.heights = heights.frame(before);
      twin.step(before);
      REQUIRE(wordsUnlike(*world.object(0).state()[0].buffer, twin.positions) == 0);
      REQUIRE(wordsUnlike(*world.object(0).state()[1].buffer, twin.velocities) == 0);
      for (std::size_t i = 0; i < twin.positions.size(); ++i) {
        if (twin.velocities[i].w < 0) continue;
        const double over = twin.positions[i].y - heights.heightAt(twin.heights, twin.positions[i]);
        min = std::min(min, over);
        touching += over < 0.051 ? 1 : 0;
      }
    }
    CHECK(min > 0.05 - 1e-5);
    CHECK(touching > 100);
  }
}

TEST_CASE("heights: a pre-roll starts with the heights of its own first frame") {
  const auto scene = sceneOf(sheetWith(""), "compute", 0.25);
  ClothTwin twin = clothTwin(scene);
  CHECK(fall(scene, twin, 20, 0.02, 0.25).min > 0.02 - 1e-5);
}

TEST_CASE("heights: falling objects have the same bits with every deformation technique") {
  testContext();
  std::vector<std::uint32_t> first;
  for (const char* technique : {"compute", "single-thread", "jobs", "mapped"}) {
    CAPTURE(technique);
    sim::World world(sceneOf(sheetWith(""), technique));
    world.advanceTo(40);
    const auto words = world.object(0).state()[0].buffer->readAll<std::uint32_t>();
    if (first.empty()) first = words;
    CHECK(words == first);
  }
}

TEST_CASE("heights: water on a deforming mesh equals its CPU twin") {
  // 0.6 s. A third of the water lies beside the mesh.
  const auto scene = sceneOf(R"("water": {"size": [46, 35], "cell": 0.1, "position": [1.5, -0.25, 0.3],
    "terrain": {"object": "swell", "bed": -0.3}, "greatestSpeed": 6})");
  testContext();
  sim::World world(scene);
  WaterTwin twin(sim::WaterPlan(dynamic_cast<const sim::WaterParameters&>(*scene.objects.at(0).parameters),
                                "faller", 5, heightsFrame));
  HeightsTwin heights(scene);
  const int substeps = twin.plan().substeps();
  std::vector<glm::vec4> start = heights.frame(0);
  for (glm::vec4& one : start) one.y = one.x;
  twin.follow(start, heights.plan.at(substeps - 1, substeps, 0, 0), true);
  const std::vector<glm::vec4> first = twin.cells;
  for (int frame = 1; frame <= 20; ++frame) {
    const double before = (frame - 1) / 60.0;
    const std::vector<glm::vec4> here = heights.frame(before);
    world.advanceTo(frame);
    for (int i = 0; i < substeps; ++i) {
      twin.follow(here, heights.plan.at(i, substeps, 0, 0), false);
      twin.advance(twin.plan().stepAt(before, i));
    }
    REQUIRE(wordsUnlike(*world.object(0).state()[0].buffer, twin.cells) == 0);
  }
  int wet = 0, moved = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    wet += first[i].x > first[i].w ? 1 : 0;
    moved += first[i].w != twin.cells[i].w ? 1 : 0;
  }
  CHECK(wet > 500);
  CHECK(wet < 1500);
  CHECK(moved > 900);
}

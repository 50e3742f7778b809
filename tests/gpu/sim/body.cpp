// Tests skinned bodies. Compares the kernel with its CPU twin bit for bit, and with its equation in double
// precision. Also tests cloth on bodies.
#include "gpu/context.hpp"
#include "gpu/sim/words.hpp"
#include "reference/body_twin.hpp"
#include "reference/cloth_twin.hpp"
#include "reference/garment_twin.hpp"
#include "scene/load.hpp"
#include "sim/body/bones.hpp"
#include "sim/body/skinned_surface.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"
#include "source_folder.hpp"
#include "unit/figure_text.hpp"
#include "unit/help.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

using namespace simreel;

namespace {

sim::BodyParameters walkerBody() {
  sim::BodyParameters p;
  p.file = sourceFolder() + "/assets/meshes/walker.gltf";
  p.animation = "walk";
  p.position =
      scene::Animated<glm::vec3>({{0, glm::vec3(0)}, {1, glm::vec3(0.3F, 0, 1)}}, scene::Ease::linear);
  p.rotation = glm::vec3(0, 31, 4);
  p.scale = 1.3F;
  p.bones.push_back({"head", glm::vec3(10, 30, 0), glm::vec3(0, 0.02F, 0)});
  return p;
}

scene::Scene capeScene(const std::string& more = "") {
  return scene::parseScene(fmt::format(R"({{"version": 1, "time": {{"fps": 30, "start": 0.5}}, "objects": {{
    "cape": {{"cloth": {{"size": [19, 23], "spacing": 0.03, "position": [0, 1.15, -0.2], "rotation": [-80, 0, 0],
      "fabric": {{"material": "cotton"}}, "pins": [{{"rows": [0], "to": "walker", "bone": "chest"}}]{}}}}},
    "walker": {{"body": {{"file": "{}/assets/meshes/walker.gltf", "animation": "walk", "collides": true}}}}}}}})",
                                       more, sourceFolder()),
                           "test.json", {}, sim::kinds());
}

}  // namespace

TEST_CASE("body: skinning equals its CPU twin at any substep, in any order") {
  testContext();
  const sim::BodyMotion motion("walker", walkerBody());
  sim::SkinnedSurface surface("walker", motion.figure(), false);
  BodyTwin twin(motion.figure());
  const auto begin = motion.rowsAt(0.3);
  const auto end = motion.rowsAt(0.35);
  surface.begin(begin, end);
  twin.skin(begin, end, 1);
  CHECK(wordsUnlike(surface.positions().buffer(), twin.positions) == 0);
  CHECK(wordsUnlike(surface.normals().buffer(), twin.normals) == 0);
  for (const auto& [substep, substeps] : std::vector<std::pair<int, int>>{
           {0, 7}, {1, 7}, {1, 7}, {2, 7}, {6, 7}, {0, 1}, {3, 5}, {4, 5}, {0, 5}}) {
    surface.moveTo(substep, substeps);
    twin.skin(begin, end, static_cast<double>(substep) / substeps);
    CHECK(wordsUnlike(surface.before().buffer(), twin.positions) == 0);
    twin.skin(begin, end, static_cast<double>(substep + 1) / substeps);
    CHECK(wordsUnlike(surface.now().buffer(), twin.positions) == 0);
    if (substep + 1 == substeps)
      CHECK(surface.now().buffer().readAll<std::uint32_t>() ==
            surface.positions().buffer().readAll<std::uint32_t>());
  }
  const auto faces = surface.faces().buffer().readAll<glm::uvec4>();
  REQUIRE(faces.size() == motion.figure().mesh.indices.size() / 3);
  CHECK(faces.back() == glm::uvec4(*(motion.figure().mesh.indices.end() - 3),
                                   *(motion.figure().mesh.indices.end() - 2),
                                   motion.figure().mesh.indices.back(), 0));
}

TEST_CASE("body: skinned vertices and normals equal the equation in double precision") {
  testContext();
  const sim::BodyParameters p = walkerBody();
  const sim::BodyMotion motion("walker", p);
  const sim::Figure& figure = motion.figure();
  sim::SkinnedSurface surface("walker", figure, false);
  const double time = 0.77;
  surface.begin(motion.rowsAt(time), motion.rowsAt(time));
  const auto positions = surface.positions().buffer().readAll<glm::vec4>();
  const auto normals = surface.normals().buffer().readAll<glm::vec4>();
  double farthest = 0;
  double maxTurned = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    glm::dmat4 blend(0);
    for (int k = 0; k < 4; ++k) {
      const sim::FigureJoint& joint = figure.joints[figure.follow[i][k]];
      blend += motion.nodeAt(joint.node, time) * joint.inverseBind * double{figure.weights[i][k]};
    }
    const glm::dvec3 place(blend * glm::dvec4(glm::dvec3(figure.mesh.positions[i]), 1));
    const glm::dvec3 normal = glm::normalize(glm::transpose(glm::inverse(glm::dmat3(blend))) *
                                             glm::dvec3(figure.mesh.normals[i]));
    farthest = std::max(farthest, glm::length(place - glm::dvec3(positions[i])));
    maxTurned = std::max(maxTurned, glm::length(normal - glm::dvec3(normals[i])));
  }
  CHECK(farthest < 2e-6);  // The distance is in metres.
  CHECK(maxTurned < 1e-5);
}

TEST_CASE("body: scaled bones keep normals perpendicular to the skin") {
  testContext();
  auto gltf = test::tubeText();
  gltf.document["nodes"][0]["scale"] = {2, 0.5, 1};
  const test::TemporaryFile file("tube.gltf", gltf.text());
  sim::BodyParameters p;
  p.file = file.path();
  const sim::BodyMotion motion("tube", p);
  sim::SkinnedSurface surface("tube", motion.figure(), false);
  surface.begin(motion.rowsAt(0), motion.rowsAt(0));
  const auto positions = surface.positions().buffer().readAll<glm::vec4>();
  const auto normals = surface.normals().buffer().readAll<glm::vec4>();
  // The ellipse x = 0.2 cos a, z = 0.1 sin a has the normal (cos a / 0.2, sin a / 0.1), before
  // normalization.
  for (std::size_t i = 24; i < positions.size() - 24; ++i) {
    const glm::dvec3 expected = glm::normalize(glm::dvec3(positions[i].x / 0.04, 0, positions[i].z / 0.01));
    CHECK(glm::length(expected - glm::dvec3(normals[i])) < 2e-3);
  }
}

TEST_CASE("body: cloth pinned to the nearest skin points equals its CPU twin, as grid and as mesh") {
  testContext();
  const auto sceneOf = [](const std::string& cloth) {
    return scene::parseScene(
        fmt::format(R"({{"version": 1, "time": {{"fps": 30, "start": 0.5}}, "objects": {{
    "cape": {{"cloth": {{{}, "position": [0, 1.15, -0.2], "rotation": [-80, 0, 0], "substeps": 9,
      "air": {{"velocity": [1, 0, 0]}}}}}},
    "walker": {{"body": {{"file": "{}/assets/meshes/walker.gltf", "animation": "walk", "collides": true}}}}}}}})",
                    cloth, sourceFolder()),
        "test.json", {}, sim::kinds());
  };
  const auto check = [](const scene::Scene& scene, const auto& make) {
    sim::World world(scene);
    world.advanceTo(20);
    const sim::Bones bones(scene);
    std::vector<sim::ColliderShape> colliders;
    bones.addCapsules(colliders);
    auto twin = make(dynamic_cast<const sim::ClothParameters&>(*scene.objects[0].parameters), colliders,
                     [&](const std::string& body, std::span<const glm::dvec3> points, double time) {
                       return bones.heldBySkin(body, points, time);
                     });
    const auto rest = twin.positions;
    for (int frame = 0; frame < 35; ++frame) twin.step((frame - 15) / 30.0);
    const std::vector<glm::vec4>* expected[] = {&twin.positions, &twin.velocities};
    for (std::size_t array = 0; array < 2; ++array)
      CHECK(wordsUnlike(*world.object(0).state()[array].buffer, *expected[array]) == 0);
    // Pinned particles follow the skin within float precision.
    std::vector<glm::dvec3> points;
    std::vector<std::size_t> pins;
    for (std::size_t i = 0; i < rest.size(); ++i)
      if (rest[i].w == 0) {
        pins.push_back(i);
        points.emplace_back(rest[i]);
      }
    REQUIRE(pins.size() > 5);
    const auto places = bones.heldBySkin("walker", points, -0.5)(20 / 30.0);
    for (std::size_t k = 0; k < pins.size(); ++k) {
      CHECK(glm::length(places[k] - glm::dvec3(twin.positions[pins[k]])) < 1e-6);
      CHECK(glm::vec3(twin.velocities[pins[k]]) == glm::vec3(0));
    }
  };
  check(sceneOf(R"("size": [19, 23], "spacing": 0.03, "fabric": {"material": "cotton"},
      "pins": [{"rows": [0], "every": 3, "to": "walker", "at": "nearest"}])"),
        [](const sim::ClothParameters& p, const auto& colliders, const sim::HeldBySkin& held) {
          return ClothTwin(sim::ClothPlan(p, 1, 1.0 / 30, colliders, {}, -0.5, held));
        });
  check(sceneOf(R"("mesh": {"size": [0.5, 0, 0.6], "resolution": [15, 18]},
      "pins": [{"vertices": [0, 2, 4, 6, 8, 10, 12, 14], "to": "walker", "at": "nearest"}])"),
        [](const sim::ClothParameters& p, const auto& colliders, const sim::HeldBySkin& held) {
          return GarmentTwin(sim::GarmentPlan("cape", p, 1, 1.0 / 30, colliders, {}, -0.5, held));
        });
}

TEST_CASE(
    "body: a cape on a walking body equals its CPU twin, does not penetrate the body and follows the "
    "bone") {
  testContext();
  const scene::Scene scene = capeScene();
  sim::World world(scene);
  std::vector<std::size_t> order;
  world.advanceTo(-14, {}, [&](std::size_t object) { order.push_back(object); });
  CHECK(order == std::vector<std::size_t>{1, 0});  // The body must step before the cloth that is pinned to
                                                   // it.
  world.advanceTo(20);
  const sim::Bones bones(scene);
  std::vector<sim::ColliderShape> colliders;
  bones.addCapsules(colliders);
  const auto& parameters = dynamic_cast<const sim::ClothParameters&>(*scene.objects[0].parameters);
  ClothTwin twin(sim::ClothPlan(
      parameters, 1, 1.0 / 30, colliders,
      [&](const std::string& body, const std::string& bone) { return bones.named(body, bone); }, -0.5));
  for (int frame = 0; frame < 35; ++frame) twin.step((frame - 15) / 30.0);
  const auto state = world.object(0).state();
  CHECK(wordsUnlike(*state[0].buffer, twin.positions) == 0);
  // The pinned row keeps its position relative to the chest bone.
  const sim::Carrier chest = bones.named("walker", "chest");
  const glm::dmat4 way = chest(20 / 30.0) * glm::inverse(chest(-0.5));
  const auto first =
      sim::ClothPlan(parameters, 1, 1.0 / 30, {}, [&](const std::string& body, const std::string& bone) {
        return bones.named(body, bone);
      }).firstPositions();
  for (std::size_t x = 0; x < 19; ++x) {
    const glm::dvec3 expected(way * glm::dvec4(glm::dvec3(first[x]), 1));
    CHECK(glm::length(expected - glm::dvec3(twin.positions[x])) < 1e-5);
  }
  // No free particle may penetrate a capsule by more than the distance that gravity adds in one substep.
  double deepest = 0;
  for (const sim::ColliderShape& shape : colliders) {
    const sim::CarriedCapsule capsule = sim::carriedAt(shape, 20 / 30.0);
    const glm::dvec3 axis = capsule.ends[1] - capsule.ends[0];
    for (std::size_t i = 19; i < twin.positions.size(); ++i) {
      const glm::dvec3 from = glm::dvec3(twin.positions[i]) - capsule.ends[0];
      const double t =
          std::min(std::max(glm::dot(from, axis) / std::max(glm::dot(axis, axis), 1e-12), 0.0), 1.0);
      deepest = std::max(deepest, capsule.radius - glm::length(from - axis * t));
    }
  }
  CHECK(deepest < 0.005);
}

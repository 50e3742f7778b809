// Tests the capsules that are fitted around bones, and their motion as colliders of cloth.
#include "scene/load.hpp"
#include "sim/body/bones.hpp"
#include "sim/body/capsules.hpp"
#include "sim/cloth/plan.hpp"
#include "sim/world/list.hpp"
#include "source_folder.hpp"
#include "unit/figure_text.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

scene::Scene tubeScene(const test::TemporaryFile& file, const std::string& more) {
  return scene::parseScene(
      fmt::format(
          R"({{"version": 1, "objects": {{"tube": {{"body": {{"file": "{}", "collides": true{}}}}}}}}})",
          file.path().string(), more),
      file.path().parent_path() / "test.json", {}, sim::kinds());
}

}  // namespace

TEST_CASE("capsules fitted to a tube have its axis and radius") {
  const test::TemporaryFile file("tube.gltf", test::tubeText().text());
  const auto capsules = sim::fitCapsules(sim::loadFigure(file.path()));
  REQUIRE(capsules.size() == 2);
  for (const sim::BoneCapsule& capsule : capsules) {
    CHECK(std::abs(capsule.radius - 0.1) < 0.001);
    CHECK(glm::length(capsule.ends[0]) < 1e-6);
    CHECK(glm::length(capsule.ends[1] - glm::dvec3(0, 0.5, 0)) < 1e-6);
  }
}

TEST_CASE("a capsule ignores protrusions and is centred in its skin") {
  const test::TemporaryFile file("tube.gltf", test::tubeText().text());
  sim::Figure figure = sim::loadFigure(file.path());
  // Moves two opposite vertices of the 24 in each ring of the lower half outwards, so that the vertices
  // form spikes.
  for (std::size_t i = 0; i < 20 * 24; i += 12) figure.mesh.positions[i] *= glm::vec3(2, 1, 2);
  for (glm::vec3& p : figure.mesh.positions) p.x += 0.03F;
  const auto capsules = sim::fitCapsules(figure);
  for (const sim::BoneCapsule& capsule : capsules) {
    CHECK(std::abs(capsule.radius - 0.1) < 0.004);
    CHECK(std::abs(capsule.ends[0].x - 0.03) < 0.002);
    CHECK(std::abs(capsule.ends[0].z) < 0.003);
  }
}

TEST_CASE("a bone without children has a capsule as long as its skin") {
  // The head is a sphere of radius 0.2 at the end of a neck that begins 0.3 below the sphere's centre.
  sim::Figure figure;
  figure.nodes.push_back({.name = "head"});
  figure.joints.push_back({0, true, glm::dmat4(1)});
  constexpr int rows = 24;
  constexpr int columns = 48;
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const double a = M_PI * r / rows;
      const double b = 2 * M_PI * c / columns;
      figure.mesh.positions.emplace_back(0.2 * std::sin(a) * std::cos(b), 0.3 + 0.2 * std::cos(a),
                                         0.2 * std::sin(a) * std::sin(b));
      figure.follow.emplace_back(0U);
      figure.weights.emplace_back(1, 0, 0, 0);
      if (r == rows) continue;
      const auto at = [&](int i, int k) {
        return static_cast<unsigned>((r + i) * columns + (c + k) % columns);
      };
      for (const unsigned corner : {at(0, 0), at(0, 1), at(1, 0), at(1, 0), at(0, 1), at(1, 1)})
        figure.mesh.indices.push_back(corner);
    }
  const auto capsules = sim::fitCapsules(figure);
  REQUIRE(capsules.size() == 1);
  // The part of the axis that belongs to the bone ends inside the sphere, so the capsule does not protrude
  // at the sphere's top.
  CHECK(std::abs(capsules[0].ends[1].y + capsules[0].radius - 0.5) < 0.005);
  CHECK(capsules[0].radius > 0.14);
  CHECK(capsules[0].radius < 0.21);
}

TEST_CASE("with many bones, those with the most skin get capsules") {
  sim::Figure figure;
  for (int bone = 0; bone < 40; ++bone) {
    figure.nodes.push_back({.name = std::to_string(bone)});
    figure.joints.push_back({bone, true, glm::dmat4(1)});
    const float size = 1.0F + 0.1F * static_cast<float>(bone * 17 % 40);
    for (const glm::vec3& corner : {glm::vec3(0), glm::vec3(size, 0, 0), glm::vec3(0, size, 0)}) {
      figure.mesh.indices.push_back(static_cast<unsigned>(figure.mesh.positions.size()));
      figure.mesh.positions.push_back(corner);
      figure.follow.emplace_back(static_cast<unsigned>(bone));
      figure.weights.emplace_back(1, 0, 0, 0);
    }
  }
  const auto capsules = sim::fitCapsules(figure);
  REQUIRE(capsules.size() == sim::maxCapsules);
  for (const sim::BoneCapsule& capsule : capsules) CHECK(capsule.node * 17 % 40 >= 16);
}

TEST_CASE("cloth steps receive positions and velocities of a moving body's capsules") {
  const test::TemporaryFile file("tube.gltf", test::tubeText().text());
  const scene::Scene scene = tubeScene(file, R"(, "animation": "bend", "scale": 2)");
  const sim::Bones bones(scene);
  std::vector<sim::ColliderShape> shapes;
  bones.addCapsules(shapes);
  REQUIRE(shapes.size() == 2);
  sim::ClothParameters p;
  p.substeps = 4;
  sim::ClothPlan plan(p, 1, 0.1, shapes);
  const auto steps = plan.frame(0.2);
  for (std::size_t i = 0; i < 4; ++i) {
    // "low" moves along x at 2 m/s in the file and therefore at 4 m/s in the scene. The capsule is twice as
    // thick.
    const shader::Collider& low = steps[i].colliders[0];
    CHECK(low.a.x == doctest::Approx(4 * (0.2 + 0.025 * static_cast<double>(i + 1))).epsilon(1e-5));
    CHECK(low.velocityA.x == doctest::Approx(4).epsilon(1e-5));
    CHECK(std::abs(low.reach - 0.2F) < 0.002F);
    CHECK(low.perLengthSquared == doctest::Approx(1).epsilon(1e-4));
    // The tip of "high" rotates by 180 degrees per second at a radius of 1 m, so v = pi m/s. Within a frame
    // it moves along a chord.
    const shader::Collider& high = steps[i].colliders[1];
    const glm::vec3 turning = glm::vec3(high.velocityB) - glm::vec3(4, 0, 0);
    CHECK(glm::length(turning) == doctest::Approx(M_PI).epsilon(0.01));
  }
}

TEST_CASE("pins follow a bone from the sheet's initial position") {
  const test::TemporaryFile file("tube.gltf", test::tubeText().text());
  const scene::Scene scene = tubeScene(file, R"(, "animation": "bend")");
  const sim::Bones bones(scene);
  sim::ClothParameters p;
  p.pins.clear();
  sim::PinGroup group;
  group.rows = {0};
  group.to = "tube";
  group.bone = "high";
  group.move = glm::vec3(0, 0, 0.5F);
  p.pins.push_back(group);
  const double frame = 0.05;
  sim::ClothPlan plan(
      p, 1, frame, {},
      [&](const std::string& body, const std::string& bone) { return bones.named(body, bone); }, 0.25);
  const auto follow = [&](const shader::ClothStep& step, const glm::vec3& at) {
    const shader::PinFrame& f = step.frames[0];
    const glm::vec4 x(at, 1);
    return glm::vec3(glm::dot(f.row0, x), glm::dot(f.row1, x), glm::dot(f.row2, x));
  };
  // "high" is at (0.5, 0.5, 0) with a rotation of 45 degrees at 0.25 s, and at (1, 0.5, 0) with 90 degrees
  // at 0.5 s.
  const glm::vec3 hung(0.5F, 1.5F, 0.2F);
  double time = 0.25 - frame;
  const glm::vec3 first = follow(plan.frame(time).back(), hung);
  CHECK(glm::length(first - glm::vec3(0.5F, 1.5F, 0.7F)) < 1e-5F);
  while (time < 0.5 - 1.5 * frame) {
    time += frame;
    static_cast<void>(plan.frame(time));
  }
  const glm::vec3 later = follow(plan.frame(0.5 - frame).back(), hung);
  const auto s = static_cast<float>(std::sqrt(0.5));
  CHECK(glm::length(later - glm::vec3(1 - s, 0.5F + s, 0.7F)) < 1e-5F);
}

TEST_CASE("the walker has 15 to 24 capsules with plausible radii") {
  const sim::Figure figure = sim::loadFigure(sourceFolder() + "/assets/meshes/walker.gltf");
  const auto capsules = sim::fitCapsules(figure);
  CHECK(capsules.size() >= 15);
  CHECK(capsules.size() <= 24);
  for (const sim::BoneCapsule& capsule : capsules) {
    CHECK(capsule.radius > 0.02);
    CHECK(capsule.radius < 0.17);
  }
}

// Tests points attached to a skin. They must follow rigid bodies exactly, and stay close to the skin.
#include "sim/body/skin_points.hpp"

#include "base/error.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/body/bones.hpp"
#include "sim/core/kind.hpp"
#include "sim/world/list.hpp"
#include "source_folder.hpp"
#include "unit/help.hpp"

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

using namespace simreel;

namespace {

std::shared_ptr<const sim::BodyMotion> walkerMotion(bool walks) {
  sim::BodyParameters p;
  p.file = sourceFolder() + "/assets/meshes/walker.gltf";
  if (walks) p.animation = "walk";
  p.position =
      scene::Animated<glm::vec3>({{0, glm::vec3(0)}, {1, glm::vec3(0.3F, 0.2F, 1)}}, scene::Ease::linear);
  p.rotation = scene::Animated<glm::vec3>({{0, glm::vec3(0, 31, 4)}, {1, glm::vec3(20, 170, -40)}},
                                          scene::Ease::linear);
  p.scale = 1.3F;
  return std::make_shared<const sim::BodyMotion>("walker", p);
}

std::string pinMistake(const std::string& pins) {
  const std::string text = R"({"version": 1, "objects": {"sheet": {"cloth": {"pins": [)" + pins + "]}}}}";
  try {
    static_cast<void>(scene::parseScene(text, sourceFolder() + "/assets/sheet.json", {}, sim::kinds()));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("skin points: points on a body that does not bend rotate and move with it") {
  const auto motion = walkerMotion(false);
  const std::vector<glm::dvec3> points = {
      {0.3, 1.9, 0.2}, {-0.4, 1.2, -0.1}, {0, 0.05, 0.3}, {0.9, 0.9, 0.9}};
  const sim::SkinPoints held("walker", motion, points, 0.25);
  const int chest = motion->boneNamed("chest");
  const glm::dmat4 before = glm::inverse(motion->nodeAt(chest, 0.25));
  for (const double time : {0.25, 0.5, 0.8}) {
    const glm::dmat4 way = motion->nodeAt(chest, time) * before;
    const auto found = held.at(time);
    REQUIRE(found.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      CHECK(glm::distance(found[i], glm::dvec3(way * glm::dvec4(points[i], 1))) < 1e-5);
  }
}

TEST_CASE(
    "skin points: points on the skin of a walking figure stay on it, points off it keep their distance") {
  const auto motion = walkerMotion(true);
  const sim::Figure& figure = motion->figure();
  // Returns a vertex of the skin, transformed by the nodes' matrices in double precision.
  const auto vertexAt = [&](std::size_t i, double time) {
    glm::dvec3 sum(0);
    for (int k = 0; k < 4; ++k) {
      const sim::FigureJoint& joint = figure.joints[figure.follow[i][k]];
      const glm::dmat4 m = motion->nodeAt(joint.node, time) * joint.inverseBind;
      sum += static_cast<double>(figure.weights[i][k]) *
             glm::dvec3(m * glm::dvec4(figure.mesh.positions[i], 1));
    }
    return sum;
  };
  std::vector<glm::dvec3> points;
  std::vector<std::size_t> vertices;
  for (std::size_t i = 0; i < figure.mesh.positions.size(); i += 97) {
    vertices.push_back(i);
    points.push_back(vertexAt(i, 0));
  }
  const std::size_t on = points.size();
  for (std::size_t i = 0; i < on; ++i) points.push_back(points[i] + glm::dvec3(0.01, 0.015, -0.02));
  const sim::SkinPoints held("walker", motion, points, 0);
  const auto start = held.at(0);
  const auto later = held.at(0.4);
  double moved = 0;
  for (std::size_t i = 0; i < on; ++i) {
    CHECK(glm::distance(start[i], points[i]) < 1e-9);
    CHECK(glm::distance(later[i], vertexAt(vertices[i], 0.4)) < 1e-5);
    moved = std::max(moved, glm::distance(later[i], start[i]));
    CHECK(glm::distance(start[on + i], points[on + i]) < 1e-9);
    double nearest = 1e9;  // distance (m) of the point to the nearest vertex of the skin; its bound is the
                           // point's distance from the skin (0.027) plus the spacing of vertices
    for (std::size_t k = 0; k < figure.mesh.positions.size(); ++k)
      nearest = std::min(nearest, glm::distance(later[on + i], vertexAt(k, 0.4)));
    CHECK(nearest < 0.08);
  }
  CHECK(moved > 0.3);
}

TEST_CASE("skin points: pins on skin are read, and errors are named") {
  test::checkHas(pinMistake(R"({"rows": [0], "at": "nearest"})"), "need \"to\"");
  test::checkHas(pinMistake(R"({"rows": [0], "to": "a", "at": "nearest", "bone": "b"})"), "follow no bone");
  test::checkHas(pinMistake(R"({"rows": [0], "to": "a", "at": "nearest", "move": [1, 0, 0]})"),
                 "leave out \"move\"");
  test::checkHas(pinMistake(R"({"rows": [0], "to": "a"})"), "\"at\": \"nearest\"");
}

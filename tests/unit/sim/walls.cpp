// Tests collisions with caves and contours by comparison with known results and with the drawn contours in
// double precision. Also tests that each error gives a clear one-line message.
#include "base/error.hpp"
#include "reference/cloth_twin.hpp"
#include "reference/particles_twin.hpp"
#include "reference/solid_twin.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/world/list.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

using FieldValue = std::function<float(int, int)>;
constexpr double wallsFrame = 1.0 / 60.0;

/// Returns the shape of a solid for a field of `size` cells with a single level at 0.5. Its rock is 1 m
/// high.
sim::SolidShape block(glm::ivec2 size, float spacing, int outside = 1) {
  sim::SolidShape shape;
  shape.size = size;
  shape.heights = {0, 1};
  shape.spacing = spacing;
  shape.outside = outside;
  return shape;
}

struct Ball {
  glm::vec3 position, velocity;
};
/// Returns spheres with the given margin near a solid around the origin, with or without weight.
ParticlesTwin ballsBeside(const sim::SolidShape& shape, const FieldValue& value,
                          const std::vector<Ball>& balls, float margin, float bounce, float weight,
                          float grip = 0, int substeps = 4) {
  sim::ParticleParameters p;
  p.groups.emplace_back().count = static_cast<int>(balls.size());
  p.method = sim::GravityMethod::none;
  p.acceleration = glm::vec3(0, -weight, 0);
  p.substeps = substeps;
  p.walls = "solid";
  p.margin = margin;
  p.bounce = bounce;
  ParticlesTwin twin(sim::ParticlePlan(p, 1, wallsFrame));
  for (std::size_t i = 0; i < balls.size(); ++i) {
    twin.positions[i] = glm::vec4(balls[i].position, 1);
    twin.velocities[i] = glm::vec4(balls[i].velocity, 0);
  }
  twin.walls.emplace(shape, value, glm::vec3(0), grip);
  return twin;
}

/// The drawn contours and their interior. They are computed in double precision and independently of grid
/// squares.
class Outlines {
 public:
  Outlines(const sim::SolidShape& shape, const FieldValue& value) : shape_(shape), twin_(shape, value) {
    const auto& lines = twin_.lines;
    for (std::size_t i = 0; i < lines.points.size(); ++i)
      walls_.push_back({placeOf(lines.points[i]), placeOf(lines.points[lines.next[i]]), lines.levels[i]});
  }
  /// True if the field reaches level `k` at point `at`. This is the case if a ray from the point crosses
  /// the contours and the block's edge an odd number of times.
  [[nodiscard]] bool reaches(int k, glm::dvec2 at) const {
    const glm::dvec2 half = 0.5 * static_cast<double>(shape_.spacing) * glm::dvec2(shape_.size + 1);
    if (std::abs(at.x) > half.x || std::abs(at.y) > half.y) return false;
    bool odd = k <= shape_.outside;
    for (const Wall& w : walls_)
      if (w.level == k && (w.a.y > at.y) != (w.b.y > at.y))
        odd ^= at.x < w.a.x + (at.y - w.a.y) / (w.b.y - w.a.y) * (w.b.x - w.a.x);
    return odd;
  }
  [[nodiscard]] double distance(int k, glm::dvec2 at) const {
    double minimum = 1e9;
    for (const Wall& w : walls_) {
      if (w.level != k) continue;
      const glm::dvec2 along = w.b - w.a;
      const double t =
          std::clamp(glm::dot(at - w.a, along) / std::max(glm::dot(along, along), 1e-30), 0.0, 1.0);
      minimum = std::min(minimum, glm::length(at - w.a - along * t));
    }
    return minimum;
  }
  /// Returns the distance (m) of an outside point from the solid. It is the minimum distance to the tops
  /// below the point and to the walls.
  [[nodiscard]] double clearance(glm::dvec3 p) const {
    double minimum = p.y;
    for (std::size_t k = 1; k < shape_.heights.size(); ++k) {
      const double over = std::max(p.y - shape_.heights[k], 0.0);
      const bool above = reaches(static_cast<int>(k), {p.x, p.z});
      minimum =
          std::min(minimum, above ? over : std::hypot(over, distance(static_cast<int>(k), {p.x, p.z})));
    }
    return minimum;
  }
  /// Returns the depth (m) of a point inside rock, or 0 outside.
  [[nodiscard]] double depth(glm::dvec3 p) const {
    double deepest = 0;
    for (std::size_t k = 1; k < shape_.heights.size(); ++k) {
      const double under = shape_.heights[k] - p.y;
      if (under > 0 && reaches(static_cast<int>(k), {p.x, p.z}))
        deepest = std::max(deepest, std::min(under, distance(static_cast<int>(k), {p.x, p.z})));
    }
    return std::max(deepest, -p.y);
  }

 private:
  struct Wall {
    glm::dvec2 a, b;
    int level;
  };
  [[nodiscard]] glm::dvec2 placeOf(glm::vec2 cell) const {
    return static_cast<double>(shape_.spacing) * (glm::dvec2(cell) - 0.5 * glm::dvec2(shape_.size - 1));
  }
  sim::SolidShape shape_;
  SolidTwin twin_;
  std::vector<Wall> walls_;
};

float noiseAt(int x, int y, int seed) {
  auto h = static_cast<unsigned>(x) * 73856093U ^ static_cast<unsigned>(y) * 19349663U ^
           static_cast<unsigned>(seed) * 83492791U;
  h = (h ^ h >> 15U) * 0x2c1b3c6dU;
  h = (h ^ h >> 12U) * 0x297a2d39U;
  return static_cast<float>((h ^ h >> 15U) >> 8U) * 5.9604645e-8F;
}

double energyOf(const ParticlesTwin& twin, std::size_t i, double weight) {
  const glm::dvec3 v(twin.velocities[i]);
  return 0.5 * glm::dot(v, v) + weight * twin.positions[i].y;
}

std::string wallsFailure(const std::string& objects) {
  try {
    static_cast<void>(scene::parseScene("{\"version\": 1, \"objects\": {\n" + objects + "}}", "test.json",
                                        {}, sim::kinds()));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
  return "no failure";
}

}  // namespace

TEST_CASE("walls: a ball reflects off a straight wall") {
  // The rock is at x > 0.13 m, at any z.
  const FieldValue slope = [](int x, int) { return 0.5F + 0.1F * (static_cast<float>(x) - 20.6F); };
  const float wall = 0.1F * (20.6F - 20.0F);
  for (const float bounce : {1.0F, 0.6F, 0.0F})
    for (const float margin : {0.0F, 0.04F, 0.25F}) {
      auto twin = ballsBeside(block({41, 41}, 0.1F), slope, {{{-0.8F, 0.4F, 0.3F}, {2, 0.1F, -1}}}, margin,
                              bounce, 0);
      double furthest = -1;
      for (int frame = 0; frame < 60; ++frame) {
        twin.step(frame * wallsFrame);
        furthest = std::max<double>(furthest, twin.positions[0].x);
      }
      CHECK(furthest <= wall - margin + 1e-6);
      CHECK(furthest > wall - margin - 2.0 / 60 - 1e-6);
      CHECK(twin.velocities[0].x == doctest::Approx(-2 * bounce).epsilon(2e-6));
      CHECK(twin.velocities[0].y == doctest::Approx(0.1));
      CHECK(twin.velocities[0].z == doctest::Approx(-1).epsilon(1e-5));
    }
}

TEST_CASE("walls: a particle along a wall loses tangential speed at the rate of grip") {
  const FieldValue slope = [](int x, int) { return 0.5F + 0.1F * (static_cast<float>(x) - 20.6F); };
  auto twin = ballsBeside(block({41, 41}, 0.1F), slope, {{{0.05F, 0.0F, 0}, {0, 0, 1}}}, 0.02F, 0, 10, 3);
  twin.positions[0].y = 0.02F;  // The new height puts the sphere on the floor, away from the wall.
  twin.positions[0].x = -0.5F;
  for (int frame = 0; frame < 30; ++frame) twin.step(frame * wallsFrame);
  CHECK(twin.positions[0].y == doctest::Approx(0.02));
  CHECK(twin.velocities[0].z == doctest::Approx(std::exp(-1.5)).epsilon(0.01).scale(0));
}

TEST_CASE(
    "walls: balls in a round pit stay inside within second order of the cell size and conserve energy") {
  double error[2] = {};
  for (const int fine : {0, 1}) {
    const int count = fine == 0 ? 24 : 96;
    const float spacing = 2.4F / static_cast<float>(count + 1);
    // The field is nonlinear, so that the positions of crossings have second-order errors.
    const FieldValue bowl = [&](int x, int y) {
      const float half = 0.5F * static_cast<float>(count - 1);
      const float dx = spacing * (static_cast<float>(x) - half),
                  dy = spacing * (static_cast<float>(y) - half);
      return 0.5F * (dx * dx + dy * dy);
    };
    std::vector<Ball> balls;
    for (int i = 0; i < 100; ++i) {
      const float turn = 2.399963F * static_cast<float>(i);
      balls.push_back({{0.5F * std::cos(turn), 0.3F, 0.5F * std::sin(turn)},
                       {3 * std::cos(5 * turn), 0, 3 * std::sin(5 * turn)}});
    }
    auto twin = ballsBeside(block({count, count}, spacing), bowl, balls, 0, 1, 0, 0, 1);
    int bounces = 0;
    for (int frame = 0; frame < 240; ++frame) {
      const auto before = twin.velocities;
      twin.step(frame * wallsFrame);
      for (std::size_t i = 0; i < balls.size(); ++i) {
        const double radius = std::hypot<double>(twin.positions[i].x, twin.positions[i].z);
        CHECK(radius < 1.0);  // The chords of the contour are inside the circle.
        if (twin.velocities[i] == before[i]) continue;
        ++bounces;  // The sphere is at the wall, except for the minimum distance of a thousandth of a
                    // square.
        error[fine] = std::max(error[fine], std::abs(radius + 1e-3 * static_cast<double>(spacing) - 1.0));
      }
    }
    for (std::size_t i = 0; i < balls.size(); ++i)
      CHECK(energyOf(twin, i, 0) == doctest::Approx(4.5).epsilon(1e-4));
    CHECK(bounces > 300);
  }
  CHECK(error[0] < 0.01);
  CHECK(error[0] / error[1] > 10);  // Second order would give a factor of 15, because the squares are 97/25
                                    // times as wide.
  MESSAGE("off the circle by " << error[0] << " m and " << error[1] << " m");
}

TEST_CASE("walls: particles land on top of rock, and beside it on the floor") {
  const FieldValue table = [](int x, int y) { return x >= 8 && x < 16 && y >= 8 && y < 16 ? 1.0F : 0.0F; };
  auto twin = ballsBeside(block({24, 24}, 0.1F, 0), table,
                          {{{0.05F, 1.7F, 0}, {0, 0, 0}},
                           {{0.9F, 1.7F, 0}, {0, 0, 0}},
                           {{0.39F, 1.6F, 0.1F}, {0.5F, 0, 0}},
                           {{3, 1.7F, 0}, {0, 0, 0}}},
                          0.05F, 0, 10, 5);
  for (int frame = 0; frame < 120; ++frame) twin.step(frame * wallsFrame);
  CHECK(twin.positions[0].y == doctest::Approx(1.05));
  CHECK(twin.positions[1].y == doctest::Approx(0.05));
  CHECK(twin.positions[2].y == doctest::Approx(0.05));  // The sphere has fallen over the edge.
  CHECK(twin.positions[2].x > 0.449);
  CHECK(twin.positions[3].y < -10);  // The sphere keeps falling, because there is no floor outside the
                                     // block.
}

TEST_CASE("walls: with a ceiling nothing leaves, and objects on the roof stay there") {
  sim::SolidShape shape = block({24, 24}, 0.1F);
  shape.ceiling = true;
  shape.roof = 0.4F;
  const FieldValue hall = [](int x, int y) { return x >= 6 && x < 18 && y >= 6 && y < 18 ? 0.0F : 1.0F; };
  std::vector<Ball> balls;
  for (int i = 0; i < 60; ++i) {
    const auto turn = static_cast<float>(i);
    balls.push_back({{0.1F, 0.5F, 0.1F}, {4 * std::cos(turn), 6 * std::sin(3 * turn), 4 * std::sin(turn)}});
  }
  balls.push_back({{0, 2, 0}, {0, -1, 0}});
  auto twin = ballsBeside(shape, hall, balls, 0.05F, 0.9F, 3);
  for (int frame = 0; frame < 200; ++frame) {
    twin.step(frame * wallsFrame);
    for (std::size_t i = 0; i < 60; ++i) {
      const glm::vec4 p = twin.positions[i];
      REQUIRE(p.y >= 0.05F - 1e-5F);
      REQUIRE(p.y <= 0.95F + 1e-5F);
      REQUIRE(std::max(std::abs(p.x), std::abs(p.z)) <= 0.55F + 1e-4F);
    }
    REQUIRE(twin.positions[60].y >= 1.45F - 1e-5F);
  }
}

TEST_CASE("walls: no particle passes one-cell rock at eight cells per step") {
  const FieldValue wall = [](int x, int) { return x == 30 ? 1.0F : 0.0F; };
  std::vector<Ball> balls;
  for (int i = 0; i < 100; ++i)
    balls.push_back({{-1.1F + 0.01F * static_cast<float>(i), 0.4F, 0}, {7.9F * 0.1F * 240, 0, 0}});
  auto twin = ballsBeside(block({61, 9}, 0.1F), wall, balls, 0, 0, 0);
  for (int frame = 0; frame < 2; ++frame) twin.step(frame * wallsFrame);
  for (std::size_t i = 0; i < balls.size(); ++i)
    CHECK(twin.positions[i].x == doctest::Approx(-0.05).epsilon(0.01).scale(0));
}

TEST_CASE("walls: on random terraces nothing is ever in rock, judged by the drawn contours") {
  for (const int seed : {1, 2, 3, 4}) {
    CAPTURE(seed);
    sim::SolidShape shape = block({17, 13}, 0.1F, seed % 2);
    shape.levels = {0.2F, 0.45F, 0.6F, 0.8F};
    shape.heights = {0, 0.1F, 0.15F, 0.4F, 0.5F};
    const FieldValue noise = [seed](int x, int y) {
      const float value = noiseAt(x, y, seed);
      return seed < 3 ? value : std::floor(value * 5) / 5;  // The values form flat terraces, with saddles
                                                            // and with values exactly at a level.
    };
    std::vector<Ball> balls;
    for (int i = 0; i < 200; ++i)
      balls.push_back({{1.4F * (noiseAt(i, 1, 7) - 0.5F), 0.6F + noiseAt(i, 2, 7), noiseAt(i, 3, 7) - 0.5F},
                       6.0F * glm::vec3(noiseAt(i, 4, 7) - 0.5F, 0, noiseAt(i, 5, 7) - 0.5F)});
    const float margin = seed == 2 ? 0.03F : 0.0F;
    auto twin = ballsBeside(shape, noise, balls, margin, 0.7F, 10);
    const Outlines outlines(shape, noise);
    int inside = 0, low = 0, close = 0;
    double deepest = 0;
    for (int frame = 0; frame < 120; ++frame) {
      twin.step(frame * wallsFrame);
      for (const glm::vec4& p : twin.positions) {
        // Spheres that have fallen off the block are skipped.
        if (p.y < -0.001F || std::abs(p.x) > 0.9F || std::abs(p.z) > 0.7F) continue;
        ++inside;
        low += p.y < 0.4F ? 1 : 0;
        deepest = std::max(deepest, outlines.depth(glm::dvec3(p)));
        close += outlines.clearance(glm::dvec3(p)) < 0.99 * margin ? 1 : 0;
      }
    }
    CHECK(inside > 5000);
    CHECK(low > 1000);
    CHECK(deepest < 2e-6);
    CAPTURE(close);
    CHECK(close <= inside / 200);  // A few spheres may be stuck in clefts narrower than a sphere.
  }
}

TEST_CASE("walls: a cloth on a plateau rests on its top and hangs over the edge with no vertex in rock") {
  sim::SolidShape shape = block({24, 24}, 0.1F, 0);
  const FieldValue table = [](int x, int y) {
    const float dx = static_cast<float>(x) - 11.5F, dy = static_cast<float>(y) - 11.5F;
    return 1.0F - 0.1F * std::sqrt(dx * dx + dy * dy);
  };
  for (const auto solver : {sim::ClothSolver::springs, sim::ClothSolver::constraints}) {
    sim::ClothParameters p;
    p.size = {41, 37};
    p.spacing = 0.04F;
    p.position = {0.05F, 1.1F, 0};
    p.mass = 0.002F;
    p.stiffness = 40;
    p.bend = 0.05F;
    p.damping = 2;
    p.wind = glm::vec3(0);
    p.solver = solver;
    p.substeps = solver == sim::ClothSolver::springs ? 12 : 8;
    p.pins.clear();
    p.margin = 0.02F;
    p.walls = "solid";
    ClothTwin twin(sim::ClothPlan(p, 1, wallsFrame, {}));
    twin.walls.emplace(shape, table, glm::vec3(0), 25.3F);
    const Outlines outlines(shape, table);
    double deepest = 0;
    for (int frame = 0; frame < 90; ++frame) {
      twin.step(frame * wallsFrame, 0);
      for (const glm::vec4& v : twin.positions) deepest = std::max(deepest, outlines.depth(glm::dvec3(v)));
    }
    int resting = 0, hanging = 0;
    for (const glm::vec4& v : twin.positions) {
      const double r = std::hypot<double>(v.x, v.z);
      if (r < 0.45) CHECK(v.y > 1.02F - 1e-5F);
      resting += r < 0.45 && v.y < 1.025F ? 1 : 0;
      hanging += v.y < 0.9F ? 1 : 0;
    }
    CHECK(deepest < 2e-6);
    CHECK(resting > 150);
    CHECK(hanging > 200);
  }
}

TEST_CASE("walls: particles enclosed by growing rock come out, and a rising top lifts particles on it") {
  float edge = 0;
  const FieldValue wall = [&edge](int x, int) { return 0.5F + 0.1F * (static_cast<float>(x) - edge); };
  const sim::SolidShape shape = block({41, 41}, 0.1F, 0);
  edge = 24.0F;
  auto twin = ballsBeside(shape, wall, {{{0.25F, 0.1F, 0}, {0, 0, 0}}, {{1.5F, 1.0F, 0}, {0, 0, 0}}}, 0.02F,
                          0, 10, 10);
  for (int frame = 0; frame < 120; ++frame) {
    edge = 24.0F - 0.1F * static_cast<float>(frame);  // The edge of the wall moves to the left at 0.6 m/s.
    twin.walls->cut();
    twin.walls->setHeights({0, 1.0F + 0.002F * static_cast<float>(frame)});
    twin.step(frame * wallsFrame);
    const double place = 0.1 * (static_cast<double>(edge) - 20);
    REQUIRE(twin.positions[0].x <= place - 0.02 + 1e-5);
    REQUIRE(twin.positions[1].y >= 1.02 + 0.002 * frame - 1e-5);
  }
  CHECK(twin.positions[0].y == doctest::Approx(0.02));
}

TEST_CASE("walls: an object without walls is reported at its place") {
  const std::string cave =
      R"("cave": {"cave": {}}, "hills": {"contour": {"field": "cave"}}, "ball": {"sphere": {}})";
  for (const std::string kind : {R"("particles": {"groups": [{}], )", R"("cloth": {)"}) {
    const auto naming = [&](const std::string& name) {
      return wallsFailure(cave + ",\n\"p\": {" + kind + R"("walls": ")" + name + "\"}}");
    };
    CHECK(naming("cave") == "no failure");
    CHECK(naming("hills") == "no failure");
    test::checkHas(naming("cav"), "no object is named \"cav\"");
    test::checkHas(naming("cav"), "did you mean \"cave\"");
    test::checkHas(naming("cav"), "test.json:3:");
    test::checkHas(naming("ball"), "object \"ball\" is a sphere, which has no walls");
    test::checkHas(wallsFailure("\"p\": {" + kind + R"("walls": "q"}})"),
                   "the scene has no cave and no contour");
  }
  CHECK(wallsFailure(
            cave +
            R"(, "p": {"particles": {"groups": [{}], "walls": "cave", "bounce": 1, "margin": 0.1}})") ==
        "no failure");
}

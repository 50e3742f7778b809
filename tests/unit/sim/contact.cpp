#include "reference/contact_pile.hpp"
#include "reference/crossings.hpp"
#include "sim/contact/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <span>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

using namespace simreel::shader;

#define FUNCTION inline
#define precise
struct ContactModel {
  const ContactStep& contactStep;
#include "glsl/contact/model.glsl"
};
#undef precise
#undef FUNCTION

double pointToSegment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a;
  const double t = glm::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::length(p - a - along * t);
}

double pointToTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
  const auto left = [&](const glm::dvec3& u, const glm::dvec3& v) {
    return glm::dot(glm::cross(v - u, p - u), n) >= 0;
  };
  if (left(a, b) && left(b, c) && left(c, a)) return std::abs(glm::dot(p - a, n));
  return std::min({pointToSegment(p, a, b), pointToSegment(p, b, c), pointToSegment(p, c, a)});
}

double segmentToSegment(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                        const glm::dvec3& d) {
  double minimum = std::min(
      {pointToSegment(a, c, d), pointToSegment(b, c, d), pointToSegment(c, a, b), pointToSegment(d, a, b)});
  const glm::dvec3 n = glm::cross(b - a, d - c);
  const double nn = glm::dot(n, n);
  if (nn < 1e-18) return minimum;
  const double s = glm::dot(glm::cross(c - a, d - c), n) / nn,
               t = glm::dot(glm::cross(c - a, b - a), n) / nn;
  if (s > 0 && s < 1 && t > 0 && t < 1)
    minimum = std::min(minimum, std::abs(glm::dot(c - a, n)) / std::sqrt(nn));
  return minimum;
}

}  // namespace

TEST_CASE("closest points of vertex and face, and of two edges, equal double precision") {
  ContactStep none{};
  ContactModel model{none};
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(-1, 1);
  const auto point = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
  for (int i = 0; i < 20000; ++i) {
    glm::vec3 a = point(), b = point(), c = point(), d = point();
    if (i % 3 == 1)
      c = a + (b - a) * 0.4F + point() * 0.02F;  // This choice of c makes slivers, and edges that nearly
                                                 // meet.
    if (i % 3 == 2) d = a + point() * 0.01F;
    const Near vertex = model.nearOfVertex({0, 1, 2, 3}, d, a, b, c);
    CHECK(vertex.normal.w == doctest::Approx(pointToTriangle(d, a, b, c)).epsilon(1e-4).scale(0.01));
    const Near edges = model.nearOfEdges({0, 1, 2, 3}, a, b, c, d);
    CHECK(edges.normal.w == doctest::Approx(segmentToSegment(a, b, c, d)).epsilon(1e-4).scale(0.01));
    // The gap between the edges has the stated width. If the edges are nearly parallel, the tolerance is
    // 1e-3 of their length.
    const glm::vec4 heights = model.heightsOf(edges, a, b, c, d);
    CHECK(model.gapOf(edges, heights) == doctest::Approx(edges.normal.w).epsilon(1e-3).scale(1));
  }
}

namespace {

double massOf(const ClothTwin& cloth) {
  double mass = 0;
  for (const glm::vec4& p : cloth.positions) mass += p.w > 0 ? 1.0 / static_cast<double>(p.w) : 0.0;
  return mass;
}
glm::dvec3 momentumOf(const ClothTwin& cloth) {
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < cloth.positions.size(); ++i)
    if (cloth.positions[i].w > 0)
      sum += glm::dvec3(cloth.velocities[i]) / static_cast<double>(cloth.positions[i].w);
  return sum;
}
sim::ColliderShape contactFloor() {
  sim::ColliderShape floor;
  floor.kind = sim::ColliderShape::Kind::plane;
  floor.friction = 0.5;
  return floor;
}

}  // namespace

TEST_CASE("no edge goes through a face when cloths fall on a ball and on each other") {
  std::vector<sim::ClothParameters> sheets;
  for (int i = 0; i < 3; ++i)
    sheets.push_back(silk({13, 11}, 0.04F, {0.01F * i, 0.34F + 0.03F * i, 0}, {0, 25.0F * i, 0}));
  sim::ColliderShape ball;
  ball.position = glm::vec3(0, 0.15F, 0);
  ball.radius = 0.12F;
  Pile pile(sheets, {ball, contactFloor()}, 0.005F, 0.3F);
  std::size_t touching = 0, stopped = 0;
  for (int f = 0; f < 60; ++f) {
    pile.step();
    touching += pile.contact->touching;
    stopped += pile.contact->stopped;
    CHECK(crossings(pile.points(), pile.faces) == 0);
  }
  CHECK(touching > 1000);
  CHECK(stopped > 0);
}

TEST_CASE("contact between cloths conserves momentum") {
  auto lower = silk({9, 7}, 0.05F, {0, 0, 0}, {0, 0, 0});
  auto upper = silk({7, 11}, 0.04F, {0.01F, 0.05F, 0.01F}, {10, 30, 0});
  for (auto* p : {&lower, &upper}) {
    p->damping = 0;
    p->gravity = glm::vec3(0);
  }
  lower.fabric->material = sim::FabricMaterial::denim;
  Pile pile({lower, upper}, {}, 0.005F, 0.5F);
  for (glm::vec4& v : pile.cloths[1]->velocities) v = glm::vec4(0.3F, -1.0F, 0.1F, 0);
  const glm::dvec3 before = momentumOf(*pile.cloths[0]) + momentumOf(*pile.cloths[1]);
  for (int f = 0; f < 10; ++f) {
    pile.step();
  }
  const glm::dvec3 lowers = momentumOf(*pile.cloths[0]);
  const glm::dvec3 after = lowers + momentumOf(*pile.cloths[1]);
  CHECK(lowers.y < 0.3 * before.y);  // Both values are negative, so much of the momentum has been
                                     // transferred.
  CHECK(glm::length(after - before) <
        8e-3 * glm::length(before));  // The limits on corrections lose some momentum.
}

TEST_CASE("a stack of cloths comes to rest, one thickness apart") {
  std::vector<sim::ClothParameters> sheets;
  for (int i = 0; i < 4; ++i) {
    sheets.push_back(silk({9, 8}, 0.05F, {0.003F * i, 0.012F + 0.006F * i, 0}, {0, 20.0F * i, 0}));
    sheets.back().damping = 1;
    sheets.back().margin = 0.003F;
  }
  Pile pile(sheets, {contactFloor()}, 0.005F, 0.4F);
  for (int f = 0; f < 150; ++f) pile.step();
  double fastest = 0;
  std::vector<double> heights;
  for (const auto& cloth : pile.cloths) {
    for (const glm::vec4& v : cloth->velocities) fastest = std::max(fastest, glm::length(glm::dvec3(v)));
    heights.push_back(cloth->positions[9 * 4 + 4].y);
  }
  CHECK(fastest < 0.02);
  for (std::size_t i = 1; i < heights.size(); ++i) {
    CHECK(heights[i] - heights[i - 1] > 0.0035);
    CHECK(heights[i] - heights[i - 1] < 0.006);
  }
}

TEST_CASE("cloth on a slope of cloth sticks below atan(mu) and slides at the expected speed above") {
  for (const double degrees : {12.0, 35.0}) {
    const double mu = 0.4;
    auto slope = silk({21, 9}, 0.05F, {0, 0, 0}, {0, 0, static_cast<float>(-degrees)});
    slope.jitter = 0;
    for (int y = 0; y < 9; ++y) slope.pins.resize(1), slope.pins[0].rows.push_back(y);
    const double angle = degrees * 3.14159265358979 / 180;
    const glm::vec3 up(std::sin(angle), std::cos(angle), 0), down(std::cos(angle), -std::sin(angle), 0);
    auto sheet = silk({7, 5}, 0.03F, up * 0.0051F - down * 0.25F, {0, 0, static_cast<float>(-degrees)});
    sheet.damping = 0;
    sheet.jitter = 0;
    Pile pile({slope, sheet}, {}, 0.005F, static_cast<float>(mu));
    const double start = momentumOf(*pile.cloths[1]).x;
    CHECK(start == 0);
    double at = 0;
    const int frames = 30;
    for (int f = 0; f < frames; ++f) pile.step();
    for (const glm::vec4& p : pile.cloths[1]->positions) at += glm::dot(glm::vec3(p), down) / 35.0;
    const double speed = glm::dot(momentumOf(*pile.cloths[1]), glm::dvec3(down)) / massOf(*pile.cloths[1]);
    const double time = frames / 60.0;
    if (degrees < 20) {
      CHECK(std::abs(speed) < 0.002);
      CHECK(std::abs(at + 0.25) < 0.001);
    } else {
      const double acceleration = 9.8 * (std::sin(angle) - mu * std::cos(angle));
      CHECK(speed == doctest::Approx(acceleration * time).epsilon(0.06).scale(0));
    }
  }
}

TEST_CASE("initial intersections are counted as by testing every pair") {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1, 1);
  for (const float size :
       {0.05F, 0.2F, 0.6F}) {  // sizes of triangles in a cube of 2 m; three of the triangles share a corner
    sim::ContactPart part;
    std::vector<glm::dvec3> points;
    for (unsigned i = 0; i < 300; ++i) {
      const glm::vec3 middle(unit(random), unit(random), unit(random));
      for (int k = 0; k < 3; ++k)
        part.positions.emplace_back(middle + size * glm::vec3(unit(random), unit(random), unit(random)),
                                    1.0F);
      part.faces.emplace_back(3 * i, 3 * i + 1, i % 3 == 0 ? 3 * i + 2 : 3 * i - 1);
    }
    for (const glm::vec4& p : part.positions) points.emplace_back(p);
    const sim::ContactPlan plan(std::span(&part, 1), 0.001);
    const long found = sim::crossingsOf(plan, part.positions);
    CHECK(found > (size > 0.1F ? 10 : -1));
    CHECK(found == crossings(points, part.faces));
  }
}

namespace {

sim::ParticleParameters oneBall(float mass, float radius, glm::vec3 position, glm::vec3 velocity) {
  sim::ParticleParameters p;
  p.method = sim::GravityMethod::none;
  p.collides = true;
  p.margin = radius;
  p.bounce = 0;
  sim::ParticleGroup& group = p.groups.emplace_back();
  group.count = 1;
  group.radius = 1e-4F;
  group.totalMass = mass;
  group.position = position;
  group.velocity = velocity;
  return p;
}

}  // namespace

TEST_CASE(
    "a ball bounces off a fixed sheet with its restitution, and friction takes mu times that impulse") {
  auto sheet = silk({9, 7}, 0.05F, {0, 0, 0}, {0, 0, 0});
  sheet.gravity = glm::vec3(0);
  auto& pins = sheet.pins.emplace_back();
  for (int row = 0; row < 7; ++row) pins.rows.push_back(row);
  auto ball = oneBall(0.02F, 0.02F, {-0.03F, 0.05F, 0.004F}, {1.5F, -2.0F, 0});
  ball.bounce = 0.5F;
  Pile pile({sheet}, {}, 0.005F, 0.3F, {}, &ball);
  for (int f = 0; f < 3; ++f) pile.step();
  const glm::vec4 v = pile.balls->velocities[0];
  CHECK(v.y == doctest::Approx(1.0).epsilon(0.01));
  CHECK(v.x == doctest::Approx(1.5 - 0.3 * 3.0).epsilon(0.01));
  CHECK(std::abs(v.z) < 0.01);
}

TEST_CASE("a ball hitting a loose sheet conserves momentum and does not pass through") {
  auto sheet = silk({9, 7}, 0.05F, {0, 0, 0}, {0, 0, 0});
  sheet.damping = 0;
  sheet.gravity = glm::vec3(0);
  for (const float mass : {0.002F, 0.05F}) {  // The masses are lower and higher than the sheet's 14 g.
    const auto ball = oneBall(mass, 0.02F, {0.01F, 0.05F, 0.004F}, {0.2F, -4.0F, 0.1F});
    Pile pile({sheet}, {}, 0.005F, 0.3F, {}, &ball);
    const auto ballMomentum = [&] {
      return glm::dvec3(pile.balls->velocities[0]) * static_cast<double>(pile.balls->positions[0].w);
    };
    const glm::dvec3 before = ballMomentum();
    for (int f = 0; f < 4; ++f) pile.step();
    const glm::dvec3 sheets = momentumOf(*pile.cloths[0]), after = sheets + ballMomentum();
    CHECK(sheets.y < 0.15 * before.y);
    // In the hardest steps, the limits on corrections lose a hundredth of the momentum of heavy ball and
    // sheet.
    CHECK(glm::length(after - before) < 1.5e-2 * glm::length(before));
    double highest =
        -10;  // highest point of the sheet around the ball, which is above the sheet and does not touch it
    for (const glm::vec4& p : pile.cloths[0]->positions)
      if (glm::length(glm::dvec2(p.x - pile.balls->positions[0].x, p.z - pile.balls->positions[0].z)) <
          0.03)
        highest = std::max(highest, static_cast<double>(p.y));
    CHECK(highest < static_cast<double>(pile.balls->positions[0].y) - 0.01);
  }
}

TEST_CASE("a ball hangs in a strip: the tension on both sides carries its weight") {
  const double half = 0.3, width = 0.03, stiffness = 500, mass = 0.03, density = 0.3;
  auto strip = silk({21, 2}, 0.03F, {0, 0, 0}, {0, 0, 0});
  strip.pins.emplace_back().columns = {0, -1};
  strip.fabric->weft = stiffness;
  strip.fabric->density = density;
  strip.damping = 8;
  auto ball = oneBall(static_cast<float>(mass), 0.02F, {0.004F, 0.03F, 0}, {0, 0, 0});
  ball.acceleration = glm::vec3(0, -9.8F, 0);
  ball.damping = 12;
  Pile pile({strip}, {}, 0.004F, 0.3F, {}, &ball);
  for (int f = 0; f < 90; ++f) pile.step();
  CHECK(std::abs(pile.balls->velocities[0].y) < 0.01);
  // Equilibrium of the ball and half of the strip. 2 T d / l = m g, with T = k w (l - L) / L and l^2 = L^2
  // + d^2. d is the distance by which the ball hangs down. L and l are the rest length and the stretched
  // length of each half. T is the tension, w the width, k the stiffness per width and m the mass.
  const double weight = 9.8 * (mass + 0.5 * density * 2 * half * width);
  double low = 0, high = half;
  for (int i = 0; i < 60; ++i) {
    const double d = 0.5 * (low + high), l = std::sqrt(half * half + d * d);
    (2 * stiffness * width * (l - half) / half * d / l < weight ? low : high) = d;
  }
  CHECK(low > 0.04);
  CHECK(0.022 - static_cast<double>(pile.balls->positions[0].y) == doctest::Approx(low).epsilon(0.05));
}

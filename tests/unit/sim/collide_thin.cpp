// Tests that rods and spheres thinner than the cells of a cloth do not pass between its vertices.
#include "reference/cloth_twin.hpp"
#include "reference/garment_twin.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

constexpr double thinFrame = 1.0 / 60.0;

enum class ThinCloth { springs, constraints, mesh };

/// Returns a hanging sheet of 1 m in the plane z = 0, with its top at y = 0.5 and vertices 5 cm apart.
sim::ClothParameters hangingSheet(ThinCloth kind) {
  sim::ClothParameters p;
  p.size = {21, 21};
  p.spacing = 0.05F;
  p.rotation = glm::vec3(90, 0, 0);  // The rotation makes the rows go down.
  p.wind = glm::vec3(0);
  p.margin = 0.005F;
  p.damping = 0.3F;
  p.substeps.reset();
  p.pins.clear();
  if (kind == ThinCloth::springs) {
    p.mass = 0.002F;
    p.stiffness = 300;
  } else {
    p.fabric.emplace();
    p.solver = sim::ClothSolver::constraints;
  }
  sim::PinGroup top;
  if (kind == ThinCloth::mesh) {
    p.mesh.emplace();
    p.mesh->shape = sim::ClothShape::plane;
    p.mesh->size = glm::vec3(1, 0, 1);
    p.mesh->resolution = {21, 21};
    top.box = sim::PinBox{glm::vec3(-1, 0.49F, -1), glm::vec3(1, 1, 1)};
  } else {
    top.rows = {0};
  }
  p.pins.push_back(top);
  return p;
}

sim::ColliderShape flying(float radius, float length, const glm::vec3& turn, const glm::vec3& from,
                          float speed) {
  sim::ColliderShape rod;
  rod.kind = length > 0 ? sim::ColliderShape::Kind::capsule : sim::ColliderShape::Kind::sphere;
  rod.radius = radius;
  rod.length = length;
  rod.rotation = turn;
  rod.position =
      scene::Animated<glm::vec3>({{0.0, from}, {1.0, from + glm::vec3(0, 0, speed)}}, scene::Ease::linear);
  rod.friction = 0.3;
  return rod;
}

/// Returns the distance between two segments in double precision, found by a search along the first
/// segment.
double segmentsApart(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const auto toSecond = [&](double s) {
    const glm::dvec3 p = a + s * (b - a);
    const double squared = glm::dot(d - c, d - c);
    const double t = squared > 0 ? std::clamp(glm::dot(p - c, d - c) / squared, 0.0, 1.0) : 0;
    return glm::length(p - c - t * (d - c));
  };
  double low = 0, high = 1;  // A ternary search works because the distance is a convex function of s.
  for (int i = 0; i < 25; ++i) {
    const double first = low + (high - low) / 3;
    const double second = high - (high - low) / 3;
    (toSecond(first) < toSecond(second) ? high : low) = toSecond(first) < toSecond(second) ? second : first;
  }
  return toSecond(0.5 * (low + high));
}

/// True if the segment p-q crosses a triangle.
bool goesThrough(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& a, const glm::dvec3& b,
                 const glm::dvec3& c) {
  const auto volume = [](const glm::dvec3& w, const glm::dvec3& x, const glm::dvec3& y,
                         const glm::dvec3& z) { return glm::dot(glm::cross(x - w, y - w), z - w); };
  if (volume(p, a, b, c) * volume(q, a, b, c) >= 0) return false;
  const double ab = volume(p, q, a, b);
  const double bc = volume(p, q, b, c);
  const double ca = volume(p, q, c, a);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

using Triples = std::vector<glm::uvec3>;

Triples facesOf(ClothTwin& twin) {
  const glm::ivec2 size = twin.plan().parameters().size;
  Triples faces;
  for (int y = 0; y + 1 < size.y; ++y)
    for (int x = 0; x + 1 < size.x; ++x) {
      const auto a = static_cast<unsigned>(y * size.x + x);
      const auto below = a + static_cast<unsigned>(size.x);
      faces.push_back({a, below, a + 1});
      faces.push_back({a + 1, below, below + 1});
    }
  return faces;
}

Triples facesOf(GarmentTwin& twin) {
  Triples faces;
  for (const glm::uvec4& face : twin.plan().arrays().corners) faces.emplace_back(face);
  return faces;
}

struct Passage {
  double nearest = 1e9;  ///< distance (m) from the axis to the nearest edge
  bool through = false;  ///< true if the axis has crossed a face
  bool ahead = true;     ///< true if the cloth has always stayed in front of the rod's middle
  double fastest = 0;    ///< maximum speed of the vertices, m/s
};

/// Simulates some frames and measures after each substep.
template <class Twin>
Passage flyInto(Twin twin, int frames) {
  Passage passage;
  const Triples faces = facesOf(twin);
  for (int frame = 0; frame < frames; ++frame) {
    int index = 0;
    for (const shader::ClothStep& step : twin.plan().frame(frame * thinFrame)) {
      twin.substep(step, index++);
      const glm::dvec3 a(step.colliders[0].a);
      const glm::dvec3 b(step.colliders[0].b);
      const glm::dvec3 middle = 0.5 * (a + b);
      int before = 0;
      for (const glm::uvec3& face : faces) {
        const glm::dvec3 p[3] = {glm::dvec3(twin.positions[face.x]), glm::dvec3(twin.positions[face.y]),
                                 glm::dvec3(twin.positions[face.z])};
        before += goesThrough(middle, middle + glm::dvec3(0, 0, 9), p[0], p[1], p[2]) ? 1 : 0;
        if (std::max({p[0].z, p[1].z, p[2].z}) < std::min(a.z, b.z) - 0.02) continue;
        for (int k = 0; k < 3; ++k)
          passage.nearest = std::min(passage.nearest, segmentsApart(a, b, p[k], p[(k + 1) % 3]));
        if (goesThrough(a, b, p[0], p[1], p[2])) passage.through = true;
      }
      passage.ahead = passage.ahead && before > 0;
      for (const glm::vec4& v : twin.velocities)
        passage.fastest = std::max(passage.fastest, glm::length(glm::dvec3(v)));
    }
  }
  return passage;
}

/// Gives substep() of both twins the same parameters.
struct SheetTwin : ClothTwin {
  using ClothTwin::ClothTwin;
  void substep(const shader::ClothStep& step, int index) { ClothTwin::substep(step, 1, index); }
};

Passage flyInto(ThinCloth kind, const sim::ColliderShape& rod, int frames) {
  const sim::ClothParameters p = hangingSheet(kind);
  if (kind == ThinCloth::mesh)
    return flyInto(GarmentTwin(sim::GarmentPlan("sheet", p, 5, thinFrame, {rod})), frames);
  return flyInto(SheetTwin(sim::ClothPlan(p, 5, thinFrame, {rod})), frames);
}

}  // namespace

TEST_CASE("collide: a 2 cm rod at 10 m/s does not pass through a sheet of 5 cm spacing") {
  for (const ThinCloth kind : {ThinCloth::springs, ThinCloth::constraints, ThinCloth::mesh}) {
    CAPTURE(static_cast<int>(kind));
    // The rods are midway between two rows, slanted, and short with both ends within the sheet.
    for (const auto& rod : std::vector<std::pair<float, glm::vec3>>{
             {1.6F, {0, 0, 90}}, {1.6F, {0, 0, 60}}, {0.33F, {0, 0, 90}}, {0.33F, {0, 20, 75}}}) {
      const float length = rod.first;
      const glm::vec3 turn = rod.second;
      CAPTURE(length);
      CAPTURE(turn.z);
      const Passage p = flyInto(kind, flying(0.01F, length, turn, {0.013F, -0.025F, -0.1F}, 10), 4);
      CHECK_FALSE(p.through);
      CHECK(p.nearest > 0.005);
      CHECK(p.ahead);
    }
  }
}

TEST_CASE("collide: a ball smaller than the mesh spacing does not pass, at any speed") {
  for (const ThinCloth kind : {ThinCloth::springs, ThinCloth::constraints, ThinCloth::mesh}) {
    CAPTURE(static_cast<int>(kind));
    for (const float speed : {1.0F, 10.0F}) {
      CAPTURE(speed);
      const Passage p =
          flyInto(kind, flying(0.01F, 0, {}, {0.02F, -0.031F, -0.05F}, speed), speed > 1 ? 3 : 20);
      CHECK(p.ahead);
      CHECK(p.nearest > 0.005);
      CHECK(p.fastest < 99);
      MESSAGE(p.fastest);
    }
  }
}

TEST_CASE("collide: only colliders thinner than the spacing use edge and face tests") {
  sim::ClothParameters p = hangingSheet(ThinCloth::springs);
  const auto thinAmong = [&](const std::vector<sim::ColliderShape>& shapes) {
    return sim::ClothPlan(p, 5, thinFrame, shapes).thinCount();
  };
  sim::ColliderShape plane;
  plane.kind = sim::ColliderShape::Kind::plane;
  CHECK(thinAmong({flying(0.019F, 1, {}, {}, 0), plane, flying(0.021F, 1, {}, {}, 0)}) == 1);
  CHECK(thinAmong({flying(0.029F, 0, {}, {}, 0), flying(0.031F, 0, {}, {}, 0)}) == 1);
  // Thin shapes are last in the list. The others keep their order.
  const auto step =
      sim::ClothPlan(p, 5, thinFrame, {flying(0.01F, 1, {}, {}, 0), flying(0.3F, 1, {}, {}, 0), plane})
          .frame(0)
          .front();
  CHECK(step.colliderCount == 2);
  CHECK(step.thinCount == 1);
  CHECK(step.colliders[0].reach == 0.3F);
  CHECK(step.colliders[1].plane == 1);
  CHECK(step.colliders[2].reach == 0.01F);
}

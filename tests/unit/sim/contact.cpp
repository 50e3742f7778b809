#include "reference/cloth_twin.hpp"
#include "reference/contact_twin.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

std::vector<glm::uvec3> facesOfSheet(glm::ivec2 size) {
  std::vector<glm::uvec3> faces;
  for (int y = 0; y + 1 < size.y; ++y)
    for (int x = 0; x + 1 < size.x; ++x) {
      const auto a = static_cast<unsigned>(y * size.x + x);
      const unsigned b = a + 1, c = a + static_cast<unsigned>(size.x), d = c + 1;
      faces.emplace_back(a, c, b);
      faces.emplace_back(b, c, d);
    }
  return faces;
}

/// Cloths that touch each other and themselves, by the twins.
struct Pile {
  std::vector<std::unique_ptr<ClothTwin>> cloths;
  std::unique_ptr<ContactTwin> contact;
  std::vector<glm::uvec3> faces;  ///< of all, numbered through
  double frameSeconds = 1.0 / 60.0;
  int frame = 0;

  Pile(const std::vector<sim::ClothParameters>& parameters,
       const std::vector<sim::ColliderShape>& colliders, float thickness, float friction) {
    std::vector<sim::ContactPart> parts;
    unsigned first = 0;
    for (const sim::ClothParameters& p : parameters) {
      cloths.push_back(std::make_unique<ClothTwin>(sim::ClothPlan(p, 5, frameSeconds, colliders)));
      parts.push_back({cloths.back()->positions, facesOfSheet(p.size), thickness, friction});
      for (const glm::uvec3& f : parts.back().faces) faces.push_back(f + first);
      first += static_cast<unsigned>(cloths.back()->positions.size());
    }
    contact =
        std::make_unique<ContactTwin>(sim::ContactPlan(parts, cloths.front()->plan().substepSeconds()));
  }

  void step() {
    std::vector<std::vector<shader::ClothStep>> steps;
    for (const auto& cloth : cloths) steps.push_back(cloth->plan().frame(frame * frameSeconds));
    for (std::size_t i = 0; i < steps.front().size(); ++i) {
      std::vector<ContactTwin::Part> parts;
      for (std::size_t c = 0; c < cloths.size(); ++c) {
        cloths[c]->predict(steps[c][i], 1, static_cast<int>(i));
        parts.push_back({&cloths[c]->positions, &cloths[c]->next, &cloths[c]->velocities});
      }
      contact->substep(parts, i == 0);
      for (const auto& cloth : cloths) cloth->finish();
    }
    ++frame;
  }

  [[nodiscard]] std::vector<glm::dvec3> points() const {
    std::vector<glm::dvec3> all;
    for (const auto& cloth : cloths)
      for (const glm::vec4& p : cloth->positions) all.emplace_back(p);
    return all;
  }
};

/// Whether p-q goes through a triangle, by signed volumes in float64.
bool crosses(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& a, const glm::dvec3& b,
             const glm::dvec3& c) {
  const auto volume = [](const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& w,
                         const glm::dvec3& x) { return glm::dot(glm::cross(v - u, w - u), x - u); };
  if ((volume(a, b, c, p) > 0) == (volume(a, b, c, q) > 0)) return false;
  const bool s = volume(p, q, a, b) > 0;
  return s == (volume(p, q, b, c) > 0) && s == (volume(p, q, c, a) > 0);
}

/// Edges that go through faces of which they have no corner.
int crossings(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& faces) {
  int count = 0;
  for (const glm::uvec3& f : faces) {
    const glm::dvec3 &a = points[f.x], &b = points[f.y], &c = points[f.z];
    const glm::dvec3 low = glm::min(glm::min(a, b), c), high = glm::max(glm::max(a, b), c);
    for (const glm::uvec3& g : faces)
      for (int k = 0; k < 3; ++k) {
        const unsigned u = g[k], v = g[(k + 1) % 3];
        if (u == f.x || u == f.y || u == f.z || v == f.x || v == f.y || v == f.z) continue;
        const glm::dvec3 &p = points[u], &q = points[v];
        bool apart = false;
        for (int axis = 0; axis < 3; ++axis)
          apart =
              apart || std::max(p[axis], q[axis]) < low[axis] || std::min(p[axis], q[axis]) > high[axis];
        count += !apart && crosses(p, q, a, b, c) ? 1 : 0;
      }
  }
  return count;
}

sim::ClothParameters silk(glm::ivec2 size, float spacing, glm::vec3 position, glm::vec3 rotation) {
  sim::ClothParameters p;
  p.size = size;
  p.spacing = spacing;
  p.position = position;
  p.rotation = rotation;
  p.jitter = 1e-4F;
  p.hasFabric = true;
  p.fabric.material = sim::FabricMaterial::cotton;
  p.wind = glm::vec3(0);
  p.substeps = std::getenv("SUB") != nullptr ? std::atoi(std::getenv("SUB")) : 8;
  p.damping = 0.5F;
  p.pins.clear();
  return p;
}

}  // namespace

TEST_CASE("contact trial" * doctest::skip()) {
  const int n = std::getenv("SHEETS") != nullptr ? std::atoi(std::getenv("SHEETS")) : 3;
  const int frames = std::getenv("FRAMES") != nullptr ? std::atoi(std::getenv("FRAMES")) : 90;
  std::vector<sim::ClothParameters> sheets;
  for (int i = 0; i < n; ++i)
    sheets.push_back(silk({23, 21}, 0.03F, {0.02F * i, 0.5F + 0.06F * i, 0}, {0, 25.0F * i, 0}));
  sim::ColliderShape ball;
  ball.position = glm::vec3(0, 0.2F, 0);
  ball.radius = 0.15F;
  ball.friction = 0.3;
  sim::ColliderShape floor;
  floor.kind = sim::ColliderShape::Kind::plane;
  floor.friction = 0.5;
  Pile pile(sheets, {ball, floor}, 0.004F, 0.3F);
  std::printf("substeps %d\n", pile.cloths[0]->plan().substeps());
  for (int f = 0; f < frames; ++f) {
    pile.step();
    double speed = 0, low = 9, high = -9, fastest = 0;
    long count = 0;
    for (const auto& cloth : pile.cloths)
      for (std::size_t i = 0; i < cloth->positions.size(); ++i) {
        const double v = glm::length(glm::dvec3(cloth->velocities[i]));
        speed += v;
        fastest = std::max(fastest, v);
        ++count;
        low = std::min<double>(low, cloth->positions[i].y);
        high = std::max<double>(high, cloth->positions[i].y);
      }
    if (f % 5 == 4)
      std::printf(
          "%3d: pairs %zu near %zu touching %zu stopped %zu all %d searches %ld | mean speed %.4f max %.3f "
          "y %.4f..%.4f crossings %d\n",
          f + 1, pile.contact->pairs, pile.contact->nears, pile.contact->touching, pile.contact->stopped,
          pile.contact->allStopped ? 1 : 0, pile.contact->searches, speed / count, fastest, low, high,
          crossings(pile.points(), pile.faces));
  }
}

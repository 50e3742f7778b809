// Tests fabrics by comparison with closed forms and with an independent implementation of their energy in
// double precision. Also tests refused settings of "fabric".
#include "base/error.hpp"
#include "reference/cloth_twin.hpp"
#include "sim/cloth/quantities.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

/// Returns a fabric without gravity, wind, damping or pins.
sim::ClothParameters freeFabric(glm::ivec2 size, float spacing) {
  sim::ClothParameters p;
  p.size = size;
  p.spacing = spacing;
  p.gravity = glm::vec3(0);
  p.wind = glm::vec3(0);
  p.damping = 0;
  p.pins.clear();
  p.fabric.emplace();
  return p;
}

using Points = std::vector<glm::dvec3>;

/// Returns a plate's bending energy divided by D / (2 L^2), where D is the bending stiffness and L the
/// spacing. `ghosts`: offsets (m) to the points beyond the clamped borders left, right, top and bottom;
/// null for a free border.
double plateEnergy(glm::ivec2 size, const Points& points, const glm::dvec3* const (&ghosts)[4] = {}) {
  const auto at = [&](int x, int y) { return points[static_cast<std::size_t>(y * size.x + x)]; };
  double sum = 0;
  for (int x = 0; x < size.x; ++x)
    for (int y = 0; y < size.y; ++y) {
      const double besideX = y == 0 || y == size.y - 1 ? 0.5 : 1;
      const double besideY = x == 0 || x == size.x - 1 ? 0.5 : 1;
      const glm::dvec3* const ghostX = x == 0 ? ghosts[0] : x == size.x - 1 ? ghosts[1] : nullptr;
      const glm::dvec3* const ghostY = y == 0 ? ghosts[2] : y == size.y - 1 ? ghosts[3] : nullptr;
      const auto add = [&](double weight, const glm::dvec3& d) { sum += weight * glm::dot(d, d); };
      if (x > 0 && x < size.x - 1) add(besideX, at(x - 1, y) - 2.0 * at(x, y) + at(x + 1, y));
      if (y > 0 && y < size.y - 1) add(besideY, at(x, y - 1) - 2.0 * at(x, y) + at(x, y + 1));
      if (ghostX) {  // At a clamped border, x[-1] = x[1] - 2 t with the ghost offset t. The term counts for
                     // half of the area.
        const glm::dvec3 inner = at(x == 0 ? 1 : x - 1, y);
        add(0.5 * besideX, inner - 2.0 * at(x, y) + (inner - 2.0 * *ghostX));
      }
      if (ghostY) {
        const glm::dvec3 inner = at(x, y == 0 ? 1 : y - 1);
        add(0.5 * besideY, inner - 2.0 * at(x, y) + (inner - 2.0 * *ghostY));
      }
      if (x + 1 < size.x && y + 1 < size.y)
        add(2, at(x + 1, y + 1) - at(x + 1, y) - at(x, y + 1) + at(x, y));
    }
  return sum;
}

double pseudo(std::size_t i) {
  return std::sin(12.9898 * static_cast<double>(i + 1) * static_cast<double>(i + 3));
}

}  // namespace

TEST_CASE("fabric: the bending force is the gradient of a plate's energy, including borders and clamps") {
  for (const bool clamped : {false, true}) {
    const glm::ivec2 size(7, 6);
    sim::ClothParameters p = freeFabric(size, 0.02F);
    p.rotation = glm::vec3(20, -35, 50);
    p.fabric->bending = 4e-4;  // bending stiffness of 1 N/m times the square of the spacing
    p.fabric->density = 0.2;
    p.fabric->weft = p.fabric->warp = 0.1;  // negligible compared with the bending stiffness
    p.fabric->shear = 1e-3;
    if (clamped)
      for (const int side : {0, 1, 2, 3}) {
        sim::PinGroup& group = p.pins.emplace_back();
        (side < 2 ? group.columns : group.rows) = {side % 2 == 0 ? 0 : -1};
        group.clamp = true;
      }
    p.substeps = 1;
    const double dt = 5e-4;
    sim::ClothPlan plan(p, 3, dt, {});
    ClothTwin twin(plan);
    const auto rest = twin.positions;
    const glm::dvec3 right = glm::dvec3(rest[1]) - glm::dvec3(rest[0]);
    const glm::dvec3 down = glm::dvec3(rest[7]) - glm::dvec3(rest[0]);
    const glm::dvec3 normal = glm::normalize(glm::cross(down, right));
    Points points;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      if (rest[i].w > 0) twin.positions[i] += glm::vec4(glm::vec3(normal * (2e-4 * pseudo(i))), 0);
      points.emplace_back(twin.positions[i]);
    }
    twin.substep(plan.frame(0).front());
    const glm::dvec3 inwards[4] = {right, -right, down, -down};
    const glm::dvec3* ghosts[4] = {};
    for (int side = 0; clamped && side < 4; ++side) ghosts[side] = &inwards[side];
    int looked = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (rest[i].w == 0) continue;
      Points moved = points;
      const double h = 1e-5;
      moved[i] = points[i] + h * normal;
      const double more = plateEnergy(size, moved, ghosts);
      moved[i] = points[i] - h * normal;
      const double less = plateEnergy(size, moved, ghosts);
      const double force = -0.5 * (more - less) / (2 * h);  // expected force for D / L^2 = 1 N/m
      const double found =
          glm::dot(glm::dvec3(twin.velocities[i]), normal) / dt / static_cast<double>(rest[i].w);
      CAPTURE(i);
      CHECK(found == doctest::Approx(force).epsilon(0.003).scale(1e-4));
      ++looked;
    }
    CHECK(looked == (clamped ? 20 : 42));
  }
}

TEST_CASE("fabric: a clamped strip bends by q L^4 / 8 D at any spacing") {
  constexpr double length = 0.2;
  constexpr double q = 0.115 * 0.098;  // weight per area, N/m^2
  constexpr double bending = 7.5e-4;
  const double expected = q * std::pow(length, 4) / (8 * bending);  // The end drops by 0.015 of the length.
  std::vector<double> drops;
  for (const int cells : {8, 12, 16}) {
    CAPTURE(cells);
    sim::ClothParameters p = freeFabric({cells + 1, 4}, static_cast<float>(length / cells));
    p.gravity = glm::vec3(0, -0.098F, 0);
    p.damping = 10;
    p.fabric->bending = bending;
    p.substeps.reset();
    sim::PinGroup& end = p.pins.emplace_back();
    end.columns = {0};
    end.clamp = true;
    ClothTwin twin(sim::ClothPlan(p, 3, 1.0 / 60, {}));
    for (int frame = 0; frame < 150; ++frame) twin.step(frame / 60.0);
    drops.push_back(-static_cast<double>(twin.positions[static_cast<std::size_t>(cells)].y));
    CHECK(drops.back() == doctest::Approx(expected).epsilon(0.03).scale(0));
  }
  const auto [minimum, maximum] = std::minmax_element(drops.begin(), drops.end());
  CHECK(*maximum < 1.02 * *minimum);
}

TEST_CASE(
    "fabric: the bending energy of z = (a x^2 + 2 b x y + c y^2) / 2 is D / 2 (a^2 + 2 b^2 + c^2) per "
    "area") {
  struct Shape {
    double a, b, c;
  };
  const glm::ivec2 size(61, 45);
  sim::ClothParameters p = freeFabric(size, 0.01F);
  p.fabric->bending = 1000;  // Bending is so stiff that stretching is negligible.
  p.fabric->weft = p.fabric->warp = 0.1;
  p.fabric->shear = 1e-3;
  for (const Shape s :
       {Shape{0.02, 0, 0}, Shape{0, 0.02, 0}, Shape{0, 0, -0.02}, Shape{0.01, -0.02, 0.015}}) {
    std::vector<glm::vec4> positions;
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i) {
        const double x = 0.01 * i;
        const double y = 0.01 * j;
        positions.emplace_back(x, y, 0.5 * (s.a * x * x + 2 * s.b * x * y + s.c * y * y), 1);
      }
    const std::vector<glm::vec4> still(positions.size(), glm::vec4(0));
    const auto quantities = p.quantities();
    const auto found = sim::measureCloth(p, positions, still, 0);
    const auto which = std::find_if(quantities.begin(), quantities.end(),
                                    [](const auto& q) { return std::string(q.name) == "elasticEnergy"; });
    const double energy = found[static_cast<std::size_t>(which - quantities.begin())];
    const double w = 0.01 * (size.x - 1);
    const double h = 0.01 * (size.y - 1);
    // There are no second differences at the border, so the area is one cell shorter in the direction of
    // the differences.
    const double expected =
        0.5 * 1000 * (s.a * s.a * (w - 0.01) * h + 2 * s.b * s.b * w * h + s.c * s.c * w * (h - 0.01));
    CHECK(energy == doctest::Approx(expected).epsilon(0.01).scale(0));
    CHECK(energy == doctest::Approx(0.5 * 1000 * w * h * (s.a * s.a + 2 * s.b * s.b + s.c * s.c))
                        .epsilon(0.04)
                        .scale(0));
  }
}

TEST_CASE("fabric: mass is density times area") {
  sim::ClothParameters p = freeFabric({9, 5}, 0.25F);
  p.fabric->density = 0.5;
  double sum = 0;
  for (const glm::vec4& particle : sim::ClothPlan(p, 1, 0.01, {}).firstPositions())
    sum += 1 / static_cast<double>(particle.w);
  CHECK(sum == doctest::Approx(0.5 * 2 * 1).epsilon(1e-6));
  CHECK(p.particleMass({0, 0}) == p.particleMass({4, 2}) / 4);
  CHECK(p.particleMass({8, 2}) == p.particleMass({4, 2}) / 2);
}

TEST_CASE("fabric: a hanging fabric stretches by rho g H / 2 k, at borders as inside") {
  constexpr int rows = 48;
  sim::ClothParameters p = freeFabric({5, rows}, 0.025F);
  p.gravity = glm::vec3(0, -9.8F, 0);
  p.rotation = glm::vec3(90, 0, 0);
  p.damping = 6;
  p.substeps.reset();
  p.fabric->material = sim::FabricMaterial::denim;
  p.fabric->warp = 60;
  p.fabric->shear = 0.01;
  p.pins.emplace_back().rows = {0};
  ClothTwin twin(sim::ClothPlan(p, 3, 1.0 / 60, {}));
  for (int frame = 0; frame < 400; ++frame) twin.step(frame / 60.0);
  const double height = 0.025 * (rows - 1);
  for (const std::size_t column : {0, 2, 4}) {
    const auto last = static_cast<std::size_t>(rows - 1) * 5 + column;
    const double strain = (twin.positions[column].y - twin.positions[last].y) / height - 1;
    CHECK(strain == doctest::Approx(0.4 * 9.8 * height / (2 * 60)).epsilon(0.01).scale(0));
  }
}

TEST_CASE("fabric: a hanging grid of rubber stretches by rho g H / 2 k, for any number of substeps") {
  // The diagonals, which are a third as stiff as the links, contribute to the total stiffness k.
  for (const int substeps : {6, 24}) {
    sim::ClothParameters p = freeFabric({9, 21}, 0.05F);
    p.fabric.emplace();
    p.fabric->material = sim::FabricMaterial::rubber;
    p.gravity = glm::vec3(0, -9.8F, 0);
    p.rotation = glm::vec3(90, 0, 0);
    p.damping = 6;
    p.substeps = substeps;
    p.pins.emplace_back().rows = {0};
    ClothTwin twin(sim::ClothPlan(p, 3, 1.0 / 60, {}));
    for (int frame = 0; frame < 300; ++frame) twin.step(frame / 60.0);
    const double strain =
        twin.positions[4].y - twin.positions[20 * 9 + 4].y - 1;  // elongation relative to a length of 1 m
    CAPTURE(substeps);
    CHECK(strain == doctest::Approx(0.47 * 9.8 / (2 * 750)).epsilon(0.02).scale(0));
  }
}

TEST_CASE("fabric: bending is stable up to the declared limit and unstable soon beyond it") {
  const auto fastestAfter = [](sim::ClothParameters p, double dt) {
    p.substeps = 1;
    ClothTwin twin(sim::ClothPlan(p, 3, dt, {}));
    double fastest = 0;
    for (int i = 0; i < 1500; ++i) {
      twin.step(i * dt);
      fastest = 0;
      for (const glm::vec4& v : twin.velocities)
        fastest = std::max(fastest, static_cast<double>(std::abs(v.y)));
      if (!std::isfinite(twin.positions[50].y) || fastest > 1e3) return 1e3;
    }
    return fastest * dt;
  };
  sim::ClothParameters p = freeFabric({23, 21}, 0.01F);
  p.jitter = 1e-6F;
  p.fabric->bending = 1e-4;
  p.fabric->weft = p.fabric->warp = 0.1;
  p.fabric->shear = 1e-3;
  const double declared = p.stableSeconds();
  CHECK(fastestAfter(p, 0.98 * declared) < 2e-5);
  CHECK(fastestAfter(p, 1.1 * declared) > 1e-3);
}

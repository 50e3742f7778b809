// Tests stretch of fabric meshes by comparison with closed forms. Also tests air, masses and quantities.
#include "reference/garment_twin.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/garment/pace.hpp"
#include "sim/garment/quantities.hpp"
#include "unit/help.hpp"
#include "unit/sim/garment_help.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

/// Damping (1/s) that is too small to change a digit of the result, but selects the constraints of damped
/// cloth.
constexpr float hardlyDamped = 1e-6F;

double garmentQuantity(const sim::GarmentPlan& plan, const GarmentTwin& twin, const std::string& name) {
  const auto names = plan.parameters().quantities();
  const auto values = sim::measureGarment(plan, twin.positions, twin.velocities, 0);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i].name == name) return values[i];
  FAIL("no such quantity");
  return 0;
}

/// A random rectangle of 0.2 x 0.15 m in a file, and its parameters.
struct RandomCloth {
  test::TemporaryFile file{"random.obj", test::objOf(test::rectangle(test::Kind::random, {20, 15}, 0.01))};
  sim::ClothParameters p = test::freeCloth();
  RandomCloth() {
    p.mesh->shape = sim::ClothShape::file;
    p.mesh->file = file.path();
    p.fabric->weft = 300;
    p.fabric->warp = 500;
    p.fabric->shear = 40;
  }
};

}  // namespace

TEST_CASE("garment: a uniform strain stores A / 2 (weft e^2 + warp f^2 + shear g^2) on a random mesh") {
  const RandomCloth cloth;
  const sim::GarmentPlan plan("a", cloth.p, 1, 1.0 / 60, {});
  const auto energyOf = [&](const auto& moved) {
    double sum = 0;
    for (std::size_t f = 0; f < plan.membrane().size(); ++f) {
      const sim::MembraneElement& element = plan.membrane()[f];
      const auto corner = [&](std::size_t k) {
        return moved(plan.cloth().points[plan.cloth().faces[f].corners[k]]);
      };
      const sim::FaceStiffness k =
          sim::stiffnessOf(element, plan.parameters().fabric->constants(), glm::dvec3(1e6), 0);
      sum += sim::membraneEnergy(element, k, sim::strainOf(element, corner(0), corner(1), corner(2)));
    }
    return sum;
  };
  const double area = 0.2 * 0.15;
  CHECK(energyOf([](const glm::dvec3& p) { return glm::dvec3(1.02 * p.x, 0, 0.97 * p.z); }) ==
        doctest::Approx(0.5 * area * (300 * 0.02 * 0.02 + 500 * 0.03 * 0.03)).epsilon(1e-4).scale(0));
  CHECK(energyOf([](const glm::dvec3& p) { return glm::dvec3(p.x + 0.03 * p.z, 0, p.z); }) ==
        doctest::Approx(0.5 * area * 40 * 0.03 * 0.03).epsilon(0.01).scale(0));
  GarmentTwin twin(plan);
  for (glm::vec4& v : twin.positions) v = glm::vec4(1.02F * v.x, v.y, 0.97F * v.z, v.w);
  CHECK(garmentQuantity(twin.plan(), twin, "stretch") == doctest::Approx(1.02).epsilon(1e-5));
  CHECK(garmentQuantity(twin.plan(), twin, "mass") == doctest::Approx(0.115 * area).epsilon(1e-5).scale(0));
  CHECK(garmentQuantity(twin.plan(), twin, "elasticEnergy") <
        // The energy is less than the closed form, because few substeps reach only part of it.
        0.5 * area * (300 * 0.02 * 0.02 + 500 * 0.03 * 0.03));
}

TEST_CASE("garment: a strip swinging from its end never gains energy and hardly stretches") {
  for (const bool damped : {false, true}) {
    CAPTURE(damped);
    sim::ClothParameters p = test::freeCloth();
    if (damped) p.damping = hardlyDamped;
    p.mesh->size = glm::vec3(0.25F, 0, 1);
    p.mesh->resolution = {9, 33};
    p.gravity = glm::vec3(0, -9.8F, 0);
    test::pinBox(p, glm::vec3(-9), glm::vec3(9, 9, -0.499F));
    GarmentTwin twin(sim::GarmentPlan("strip", p, 1, 1.0 / 60, {}));
    double before = garmentQuantity(twin.plan(), twin, "energy");
    const double falls = 0.5 * 0.115 * 0.25 * 9.8;  // energy in J of the hanging cloth relative to the
                                                    // horizontal cloth
    double fastest = 0;
    for (int frame = 0; frame < 180; ++frame) {
      twin.step(frame / 60.0);
      if (frame % 10 != 9) continue;
      const double now = garmentQuantity(twin.plan(), twin, "energy");
      CHECK(now < before + 0.01 * falls);
      before = now;
      fastest = std::max(fastest, garmentQuantity(twin.plan(), twin, "kineticEnergy"));
      // The most stretched face is at the pins. If energy is conserved, the energy that the swing loses to
      // flutter remains in the faces.
      CHECK(garmentQuantity(twin.plan(), twin, "stretch") < (damped ? 1.15 : 1.25));
    }
    CHECK(fastest > 0.5 * falls);
  }
}

TEST_CASE("garment: a random mesh stretched at its ends comes to rest evenly stretched") {
  RandomCloth cloth;
  cloth.p.damping = 20;
  cloth.p.fabric->weft = 3;  // The cloth is soft, so that the compliance dominates at this substep length.
  cloth.p.fabric->warp = 5;
  cloth.p.fabric->shear = 0.4;
  cloth.p.fabric->bending = 0;
  cloth.p.substeps = 40;
  test::pinBox(cloth.p, glm::vec3(-9, -9, -9), glm::vec3(-0.099F, 9, 9));
  test::pinBox(cloth.p, glm::vec3(0.099F, -9, -9), glm::vec3(9));
  cloth.p.pins[1].move =
      scene::Animated<glm::vec3>({{0.0, glm::vec3(0)}, {0.2, glm::vec3(0.01F, 0, 0)}}, scene::Ease::linear);
  GarmentTwin twin(sim::GarmentPlan("a", cloth.p, 1, 1.0 / 60, {}));
  const auto rest = twin.positions;
  for (int frame = 0; frame < 120; ++frame) twin.step(frame / 60.0);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    CHECK(twin.positions[i].x == doctest::Approx(rest[i].x * 1.05 + 0.005).epsilon(1e-4).scale(1));
    CHECK(twin.positions[i].z == doctest::Approx(rest[i].z).epsilon(1e-4).scale(1));
  }
}

TEST_CASE("garment: hanging rows, 16 to 256, stretch by rho g H / 2 k within 0.1% of their length") {
  for (const int rows : {16, 64, 256})
    for (const double warp : {15000.0, 60.0})
      for (const bool random : {false, true}) {
        CAPTURE(rows);
        CAPTURE(warp);
        const double cell = 1.0 / (rows - 1);
        const test::TemporaryFile file(
            "rows.obj", test::objOf(test::rectangle(random ? test::Kind::random : test::Kind::right,
                                                    {rows == 256 ? 4 : 3 + rows / 8, rows - 1}, cell)));
        sim::ClothParameters p = test::freeCloth();
        p.mesh->shape = sim::ClothShape::file;
        p.mesh->file = file.path();
        p.rotation = glm::vec3(90, 0, 0);
        p.gravity = glm::vec3(0, -9.8F, 0);
        p.damping = 6;
        p.fabric->warp = warp;
        if (rows == 256)
          p.fabric->bending = 1e-8;  // Bending is so weak that it needs no additional
                                     // substeps.
        test::pinBox(p, glm::vec3(-9, 0.499F, -9), glm::vec3(9));
        GarmentTwin twin(sim::GarmentPlan("rows", p, 1, 1.0 / 60, {}));
        for (int frame = 0; frame < (rows == 16 ? 300 : 150); ++frame) twin.step(frame / 60.0);
        double lowest = 1;
        for (const glm::vec4& v : twin.positions) lowest = std::min(lowest, static_cast<double>(v.y));
        const double beyond = -0.5 - lowest - 0.115 * 9.8 / (2 * warp);
        // Attachments carry exactly the load that the faces do not carry.
        CHECK(twin.plan().substeps() <= rows / 5 + 8);
        CHECK(std::abs(beyond) < 0.001);
      }
}

TEST_CASE("garment: \"auto\" takes more substeps the finer the unpinned mesh is") {
  sim::ClothParameters p = test::freeCloth();
  p.gravity = glm::vec3(0, -9.8F, 0);
  p.mesh->size = glm::vec3(1, 0, 1);
  const auto substeps = [&](int count) {
    p.mesh->resolution = {count, count};
    return sim::GarmentPlan("a", p, 1, 1.0 / 60, {}).substeps();
  };
  const int coarse = substeps(65);
  const int fine = substeps(129);
  CHECK(fine == doctest::Approx(2 * coarse).epsilon(0.1));
  test::pinBox(p, glm::vec3(-9, -9, 0.49F), glm::vec3(9));
  CHECK(substeps(129) ==
        // Attachments carry part of the load.
        doctest::Approx(fine * std::sqrt(0.1 / 0.5 / std::sqrt(2.0))).epsilon(0.2));
  p.mesh->resolution = {65, 65};
  std::vector<bool> pinned(65 * 65, false);
  const sim::ClothTriangles cloth("a", p.mesh->make(), 1, 0);
  pinned[0] = true;
  CHECK(sim::hangingLength(cloth, pinned, {}) ==
        doctest::Approx(2).epsilon(0.001));  // No diagonal edge shortens this path.
}

TEST_CASE("garment: the hanging length is measured for each connected piece, also across seams") {
  // The mesh consists of strips side by side. Each strip is 1 m long and has one column of cells. The first
  // strip is pinned at its end.
  sim::Mesh mesh = test::rectangle(test::Kind::right, {10, 1}, 0.1);
  const std::size_t count = mesh.positions.size();
  for (std::size_t i = 0; i < count; ++i)
    mesh.positions.push_back(mesh.positions[i] * 1.5F + glm::vec3(0, 0, 1));
  mesh.normals.resize(2 * count);
  for (std::size_t i = 0; i < 60; ++i)
    mesh.indices.push_back(mesh.indices[i] + static_cast<unsigned>(count));
  const sim::ClothTriangles cloth("a", mesh, 1, 0);
  std::vector<bool> pinned(2 * count, false);
  pinned[0] = pinned[11] = true;
  CHECK(sim::hangingLength(cloth, pinned, {}) == doctest::Approx(1).epsilon(1e-6));
  const double free = 0.5 * (1.5 + 0.15);  // half of the length of the path between corners that no
                                           // diagonal connects
  pinned[0] = pinned[11] = false;
  CHECK(sim::hangingLength(cloth, pinned, {}) == doctest::Approx(free).epsilon(0.001));
  pinned[0] = pinned[11] = true;
  const unsigned end = 10;
  const auto other = static_cast<unsigned>(count);  // This seam joins the far end of the first strip to the
                                                    // near end of the second.
  CHECK(sim::hangingLength(cloth, pinned, {{end, other}, {other, end}}) ==
        doctest::Approx(2.5 + 0.15 * (std::sqrt(2.0) - 1)).epsilon(0.05));
}

TEST_CASE("garment: air drag on a flat sheet across the flow is rho Cd A v^2 / 2") {
  RandomCloth cloth;
  cloth.p.air.emplace();
  cloth.p.air->velocity = glm::vec3(0, 3, 0);
  cloth.p.air->gusts = 0;
  cloth.p.air->lift = 0.7F;  // Lift has no effect on a sheet perpendicular to the flow.
  cloth.p.substeps = 64;
  GarmentTwin twin(sim::GarmentPlan("a", cloth.p, 1, 1.0 / 60, {}));
  twin.substep(twin.plan().frame(0).front());
  glm::dvec3 momentum(0);
  for (std::size_t i = 0; i < twin.velocities.size(); ++i)
    momentum += glm::dvec3(twin.velocities[i]) * twin.plan().masses()[i];
  const double force = 0.5 * 1.2 * 1.0 * 0.2 * 0.15 * 9;
  CHECK(momentum.y == doctest::Approx(force / 60 / 64).epsilon(1e-3).scale(0));
  CHECK(std::abs(momentum.x) < 1e-7);
}

TEST_CASE("garment: free in the air, cloth conserves momentum and its energy never rises") {
  for (const bool damped : {false, true}) {
    CAPTURE(damped);
    RandomCloth cloth;
    cloth.p.jitter = 0.001F;
    if (damped) cloth.p.damping = hardlyDamped;
    GarmentTwin twin(sim::GarmentPlan("a", cloth.p, 1, 1.0 / 60, {}));
    for (glm::vec4& v : twin.velocities) v.y = 0.5F;
    const double first = garmentQuantity(twin.plan(), twin, "energy");
    double halves[2] = {0, 0};
    for (int frame = 0; frame < 120; ++frame) {
      twin.step(frame / 60.0);
      const double now = garmentQuantity(twin.plan(), twin, "energy");
      halves[frame / 60] += now / 60;
      if (damped) CHECK(now < first);
    }
    // All energy is in vibrations that substeps barely resolve. It oscillates but does not decay.
    if (!damped) CHECK(halves[1] == doctest::Approx(halves[0]).epsilon(5e-3).scale(0));
    glm::dvec3 momentum(0);
    for (std::size_t i = 0; i < twin.velocities.size(); ++i)
      momentum += glm::dvec3(twin.velocities[i]) * twin.plan().masses()[i];
    CHECK(momentum.y == doctest::Approx(0.5 * 0.115 * 0.03).epsilon(1e-3).scale(0));
    CHECK(std::abs(momentum.z) < 1e-3 * momentum.y);
  }
}

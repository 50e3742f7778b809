// Tests falls onto a deformed mesh by comparison with known results. Also tests that each error gives a
// clear one-line message.
#include "base/error.hpp"
#include "reference/cloth_twin.hpp"
#include "reference/particles_twin.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"
#include "unit/help.hpp"

#include <cmath>
#include <functional>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

constexpr double frameSeconds = 1.0 / 60.0;
const glm::ivec2 vertices(9, 7);

/// Returns one particle above a surface of 8 x 6 m around (10, 2, -3).
ParticlesTwin onSurface(const glm::vec3& position, const glm::vec3& velocity, float grip, float bounce,
                        const std::function<float(float, float)>& height) {
  sim::MeshParameters mesh;
  mesh.size = glm::vec3(8, 0, 6);
  mesh.resolution = vertices;
  mesh.position = glm::vec3(10, 2, -3);
  mesh.grip = grip;
  sim::ParticleParameters p;
  p.groups.emplace_back().count = 1;
  p.method = sim::GravityMethod::none;
  p.acceleration = glm::vec3(0, -10, 0);
  p.substeps = 16;
  p.collides = true;
  p.bounce = bounce;
  p.margin = 0.1F;
  ParticlesTwin twin(sim::ParticlePlan(p, 1, frameSeconds));
  twin.positions.assign(1, glm::vec4(position, 1));
  twin.velocities.assign(1, glm::vec4(velocity, 0));
  twin.accelerations.assign(1, glm::vec4(0));
  twin.heightPlan = sim::HeightPlan(mesh, frameSeconds);
  for (int row = 0; row < vertices.y; ++row)
    for (int column = 0; column < vertices.x; ++column) {
      const float h = height(6.0F + static_cast<float>(column), -6.0F + static_cast<float>(row));
      twin.heights.emplace_back(h, h, 0, 0);
    }
  return twin;
}

std::string heightsFailure(const std::string& objects) {
  try {
    static_cast<void>(scene::parseScene("{\"version\": 1, \"objects\": {\n" + objects + "}}", "test.json",
                                        {}, sim::kinds()));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
  return "no failure";
}

std::string meshFailure(const std::string& more) {
  return heightsFailure(R"("m": {"mesh": {"collides": true)" + more + "}}");
}

}  // namespace

TEST_CASE("heights: without grip an object slides down a slope with g sin(angle)") {
  // The surface slopes along both x and z: y falls by 0.3 per metre along x and rises by 0.4 along z. So
  // the downhill direction is (0.3, -0.4) / 0.5 and tan(angle) = 0.5.
  const auto height = [](float x, float z) { return 5.0F - 0.3F * (x - 10) + 0.4F * (z + 3); };
  auto twin = onSurface({10, 5.1F, -3}, {0, 0, 0}, 0, 0, height);
  for (int frame = 0; frame < 40; ++frame) twin.step(frame * frameSeconds);
  const double t = 40 * frameSeconds;
  const double across = 0.5 * 10.0 * (0.5 / 1.25) * t * t;  // sin cos is computed as tan / (1 + tan^2).
  const glm::vec4 p = twin.positions[0];
  CHECK(p.x - 10 == doctest::Approx(0.6 * across).epsilon(0.01));
  CHECK(p.z + 3 == doctest::Approx(-0.8 * across).epsilon(0.01));
  CHECK(p.y == doctest::Approx(height(p.x, p.z) + 0.1).epsilon(1e-5));
}

TEST_CASE(
    "heights: a bounce keeps its fraction of the normal speed, and grip reduces the tangential speed") {
  const auto flat = [](float, float) { return 3.0F; };
  auto twin = onSurface({10, 4.1F, -3}, {1, 0, 0}, 0, 0.6F, flat);
  double highest = 0;
  bool landed = false;
  for (int frame = 0; frame < 50; ++frame) {
    twin.step(frame * frameSeconds);
    landed = landed || twin.velocities[0].y > 0;
    if (landed) highest = std::max<double>(highest, twin.positions[0].y - 3.1);
  }
  // The particle rebounds to restitution^2 times the drop of 1 m.
  CHECK(highest == doctest::Approx(0.36).epsilon(0.03).scale(0));
  CHECK(twin.velocities[0].x == doctest::Approx(1));
  auto sliding = onSurface({10, 3.1F, -3}, {1, 0, 0}, 2, 0, flat);
  for (int frame = 0; frame < 30; ++frame) sliding.step(frame * frameSeconds);
  CHECK(sliding.velocities[0].x == doctest::Approx(std::exp(-1.0)).epsilon(0.01).scale(0));
  CHECK(sliding.positions[0].y == doctest::Approx(3.1));
}

TEST_CASE("heights: a rising surface carries objects, halfway at half of the frame") {
  auto twin = onSurface({10, 3.1F, -3}, {0, 0, 0}, 5, 0, [](float, float) { return 3.0F; });
  for (glm::vec4& h : twin.heights) h.y = 3.6F;
  twin.step(0);
  CHECK(twin.positions[0].y == doctest::Approx(3.7));
  CHECK(twin.velocities[0].y == doctest::Approx(36).epsilon(0.01));  // The surface rises by 0.6 m in 1/60
                                                                     // s.
  const auto half = twin.heightPlan->at(7, 16, 0, 0);
  CHECK(half.progress == 0.5F);
}

TEST_CASE("heights: there is no collision beside the mesh, and there is on its edge") {
  const auto flat = [](float, float) { return 3.0F; };
  for (const glm::vec2 edge : {glm::vec2(6, -6), glm::vec2(14, 0), glm::vec2(14, -6), glm::vec2(9.5F, 0)}) {
    const glm::vec2 outwards = glm::sign(edge - glm::vec2(10, -3)) * 1e-3F;
    auto on = onSurface({edge.x, 3, edge.y}, {0, 0, 0}, 0, 0, flat);
    on.step(0);
    CHECK(on.positions[0].y == doctest::Approx(3.1));
    auto beside = onSurface({edge.x + outwards.x, 3, edge.y + outwards.y}, {0, 0, 0}, 0, 0, flat);
    beside.step(0);
    CHECK(beside.positions[0].y < 3);
  }
}

TEST_CASE("heights: a mesh that cannot collide is reported at its place") {
  const std::string deform = R"(, "deform": [{"ripple": {}}])";
  CHECK(meshFailure(deform) == "no failure");
  test::checkHas(meshFailure(deform + R"(, "shape": "sphere")"), "mesh that collides must be a \"plane\"");
  test::checkHas(meshFailure(""), "or a plane that \"deform\" moves");
  test::checkHas(meshFailure(deform + R"(, "technique": "vertex-shader")"), "keeps no positions");
  test::checkHas(meshFailure(deform + R"(, "size": [0, 0, 3])"), "at least 0.001 m");
  test::checkHas(meshFailure(deform + R"(, "rotation": [0, 20, 0])"), "cannot be turned");
  test::checkHas(meshFailure(deform + R"(, "rotation": {"keys": [[0, [0, 0, 0]], [1, [0, 20, 0]]]})"),
                 "cannot be turned");
  test::checkHas(meshFailure(deform + R"(, "scale": 2)"), "cannot be scaled");
  test::checkHas(meshFailure(deform + R"(, "position": {"keys": [[0, [0, 0, 0]], [1, [0, 1, 0]]]})"),
                 "cannot move");
  CHECK(meshFailure(deform + R"(, "position": [0, 1, 0])") == "no failure");
  test::checkHas(heightsFailure(R"("m": {"mesh": {"grip": 3}})"),
                 "\"grip\" is for a mesh with \"collides\": true");
  const std::string message = meshFailure(deform + ",\n" + R"("scale": 2)");
  test::checkHas(message, "test.json:3:");
}

TEST_CASE("heights: a scene may have only one mesh to fall onto, and colliding particles need one") {
  const std::string mesh = R"({"mesh": {"deform": [{"ripple": {}}], "collides": true}})";
  const std::string grains = R"({"particles": {"groups": [{}], "collides": true}})";
  CHECK(heightsFailure("\"a\": " + mesh + ", \"p\": " + grains) == "no failure");
  const std::string second = heightsFailure("\"a\": " + mesh + ",\n\"b\": " + mesh);
  test::checkHas(second, "the surface that others fall onto, and \"a\" is it already");
  test::checkHas(second, "test.json:3:");
  const auto problems = [&](const std::string& more) {
    const auto scene = scene::parseScene(R"({"version": 1, "objects": {"p": )" + grains + "}" + more + "}",
                                         "test.json", {}, sim::kinds());
    const auto found = sim::findProblems(scene);
    return found.empty() ? std::string("none") : std::string(found.front().what());
  };
  const std::string alone = heightsFailure("\"s\": {\"cloth\": {}},\n\"p\": " + grains);
  test::checkHas(alone, "error: there is nothing to touch; add a ground or a shape");
  test::checkHas(alone, "test.json:3:");
  CHECK(problems(R"(, "ground": {"height": -1})") == "none");
  test::checkHas(heightsFailure(R"("p": {"particles": {"groups": [{}], "bounce": 0.2}})"),
                 "for particles with \"collides\"");
  test::checkHas(heightsFailure(R"("p": {"particles": {"groups": [{}], "margin": 0.2}})"),
                 "for particles with \"collides\"");
}

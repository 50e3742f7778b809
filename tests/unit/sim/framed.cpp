// Tests the boxes that a camera without a position frames for meshes, bodies, spheres and cloth meshes.
#include "sim/body/parameters.hpp"
#include "sim/cloth/parameters.hpp"
#include "sim/mesh/parameters.hpp"
#include "sim/particles/parameters.hpp"
#include "sim/shape/shape.hpp"
#include "source_folder.hpp"

#include <cmath>
#include <filesystem>
#include <vector>

#include <doctest/doctest.h>
#include <glm/common.hpp>

using namespace simreel;

namespace {

void checkFramed(const scene::Parameters& parameters, const glm::vec3& min, const glm::vec3& max) {
  const auto box = parameters.framed();
  REQUIRE(box.has_value());
  for (int k = 0; k < 3; ++k) {
    CHECK(std::abs(box->min[k] - min[k]) < 1e-4F);
    CHECK(std::abs(box->max[k] - max[k]) < 1e-4F);
  }
}

std::filesystem::path walkerFile() {
  return std::filesystem::path(sourceFolder()) / "assets/meshes/walker.gltf";
}

}  // namespace

TEST_CASE("framed: framing contains a resting mesh at all keys of its position") {
  sim::MeshParameters mesh;  // The default mesh is a plane of 4 m by 4 m.
  mesh.scale = 0.5F;
  mesh.position = scene::Animated<glm::vec3>({{0.0, glm::vec3(0, 1, 0)}, {1.0, glm::vec3(3, 2, 0)}},
                                             scene::Ease::linear);
  checkFramed(mesh, {-1, 1, -1}, {4, 2, 1});
  mesh.rotation = glm::vec3(90, 0, 0);
  checkFramed(mesh, {-1, 0, 0}, {4, 3, 0});
  mesh.visible = false;
  CHECK_FALSE(mesh.framed());
}

TEST_CASE("framed: framing contains rotating and scaling objects over their path, also before a jump") {
  sim::MeshParameters mesh;  // The default mesh is a plane of 4 m by 4 m.
  mesh.scale = scene::Animated<float>({{0.0, 0.5F}, {2.0, 1.5F}}, scene::Ease::linear);
  checkFramed(mesh, {-3, 0, -3}, {3, 0, 3});
  sim::ShapeParameters rod(sim::ColliderShape::Kind::capsule);
  rod.shape.radius = 0.25F;
  rod.shape.length = 2;
  rod.shape.rotation =
      scene::Animated<glm::vec3>({{0.0, glm::vec3(0)}, {1.0, glm::vec3(0, 0, 90)}}, scene::Ease::linear);
  checkFramed(rod, {-1.25F, -1.25F, -0.25F}, {1.25F, 1.25F, 0.25F});
  rod.shape.rotation =
      scene::Animated<glm::vec3>({{0.0, glm::vec3(0)}, {1.0, glm::vec3(0, 0, 720)}}, scene::Ease::linear);
  const auto whirls = rod.framed();
  REQUIRE(whirls.has_value());
  CHECK(whirls->max.x > 1.23F);
  CHECK(whirls->max.x < 1.2501F);
  sim::ShapeParameters ball(sim::ColliderShape::Kind::sphere);
  ball.shape.radius = 1;
  ball.shape.position = scene::Animated<glm::vec3>(
      {{0.0, glm::vec3(0)}, {2.0, glm::vec3(5, 0, 0)}, {2.0, glm::vec3(0, 3, 0)}}, scene::Ease::linear);
  checkFramed(ball, {-1, -1, -1}, {6, 4, 1});
}

TEST_CASE("framed: framing contains balls and capsules but not planes") {
  sim::ShapeParameters capsule(sim::ColliderShape::Kind::capsule);
  capsule.shape.radius = 0.25F;
  capsule.shape.rotation = glm::vec3(0, 0, 90);
  capsule.shape.position = glm::vec3(1, 2, 3);
  checkFramed(capsule, {-0.25F, 1.75F, 2.75F}, {2.25F, 2.25F, 3.25F});
  CHECK_FALSE(sim::ShapeParameters(sim::ColliderShape::Kind::plane).framed());
}

TEST_CASE("framed: framing contains a body's skin over its motion") {
  sim::BodyParameters body;
  body.file = walkerFile();
  const auto stands = body.framed();
  REQUIRE(stands.has_value());
  CHECK(std::abs(stands->min.y) < 0.05F);
  CHECK(stands->max.y > 1.5F);
  CHECK(stands->max.y < 2);
  body.animation = "walk";
  const auto walks = body.framed();
  REQUIRE(walks.has_value());
  // The box of the walking body is longer by the length of a step.
  CHECK(walks->max.z - walks->min.z > stands->max.z - stands->min.z + 0.2F);
  body.scale = 2.0F;
  body.position = glm::vec3(10, 0, 0);
  const auto moved = body.framed();
  REQUIRE(moved.has_value());
  CHECK(std::abs(moved->max.y - 2 * walks->max.y) < 1e-3F);
  CHECK(std::abs(moved->min.x - 10 - 2 * walks->min.x) < 1e-3F);
}

TEST_CASE("framed: unreadable files do not change the camera") {
  sim::BodyParameters body;
  body.file = "/no/such.gltf";
  CHECK_FALSE(body.framed());
  body.file = walkerFile();
  body.animation = "swim";
  CHECK_FALSE(body.framed());
  sim::MeshParameters mesh;
  mesh.shape = sim::MeshShape::file;
  mesh.file = "/no/such.obj";
  CHECK_FALSE(mesh.framed());
}

TEST_CASE("framed: framing contains mesh cloth at rest and where it falls or hangs") {
  sim::ClothParameters cloth;
  cloth.mesh.emplace();
  cloth.mesh->size = glm::vec3(3, 0, 1);
  cloth.position = glm::vec3(0, 2, 0);
  cloth.pins.clear();
  checkFramed(cloth, {-1.5F, 0, -0.5F}, {1.5F, 2, 0.5F});
  cloth.pins.emplace_back().vertices = {0};
  checkFramed(cloth, {-1.5F, -1, -0.5F}, {1.5F, 2, 0.5F});
}

TEST_CASE("framed: framing contains particles at their start and as far as emitters throw them") {
  sim::ParticleParameters cloud;
  cloud.size = 0;
  CHECK_FALSE(cloud.framed());
  sim::ParticleGroup group;
  group.shape = sim::ParticleGroup::Shape::ball;
  group.radius = 0.5F;
  group.position = glm::vec3(1, 2, 3);
  cloud.groups = {group};
  checkFramed(cloud, {0.5F, 1.5F, 2.5F}, {1.5F, 2.5F, 3.5F});
  CHECK(cloud.framed()->round);
  cloud.groups[0].shape = sim::ParticleGroup::Shape::disk;
  checkFramed(cloud, {-0.5F, 1.775F, 1.5F}, {2.5F, 2.225F, 4.5F});
  cloud.groups[0].shape = sim::ParticleGroup::Shape::ball;
  cloud.acceleration = glm::vec3(0, -9.8F, 0);
  checkFramed(cloud, {0.5F, 0, 2.5F}, {1.5F, 2.5F, 3.5F});  // The box includes the fall of the particles.
  CHECK_FALSE(cloud.framed()->round);
  sim::Emitter fountain;
  fountain.spread = 0;
  fountain.radius = 0;
  fountain.lifetime = 2;
  fountain.velocity = glm::vec3(0, 4, 0);
  cloud.groups.clear();
  cloud.emitters = {fountain};
  cloud.acceleration = glm::vec3(1, -4, 0);
  checkFramed(cloud, {0, 0, 0}, {2, 2, 0});  // The particles rise for a second, then fall.
  CHECK_FALSE(cloud.framed()->round);
}

TEST_CASE("framed: framing of file meshes and bodies includes their extreme points") {
  const auto checkOutline = [](const scene::Parameters& parameters, const std::vector<glm::vec3>& outline) {
    const auto box = parameters.framed();
    REQUIRE(box.has_value());
    REQUIRE_FALSE(outline.empty());
    glm::vec3 low(1e9F), high(-1e9F);
    for (const glm::vec3& point : outline) low = glm::min(low, point), high = glm::max(high, point);
    CHECK(low == box->min);
    CHECK(high == box->max);
  };
  sim::MeshParameters mesh;
  CHECK(mesh.outline().empty());  // A plane has no outline, because its box is exact.
  mesh.shape = sim::MeshShape::file;
  mesh.file = std::filesystem::path(sourceFolder()) / "assets/meshes/boat.obj";
  mesh.rotation = glm::vec3(0, 30, 0);
  checkOutline(mesh, mesh.outline());
  mesh.deform.list.emplace_back().ripple.on = true;
  checkOutline(mesh, mesh.outline());
  mesh.visible = false;
  CHECK(mesh.outline().empty());
  sim::BodyParameters body;
  body.file = walkerFile();
  body.animation = "walk";
  checkOutline(body, body.outline());
}

TEST_CASE(
    "framed: particles whose size grows with mass are framed with the radius of their heaviest body") {
  sim::ParticleParameters particles;
  sim::ParticleGroup group;
  group.shape = sim::ParticleGroup::Shape::disk;
  group.radius = 1;
  group.thickness = 0;
  group.count = 100;
  group.totalMass = 100;
  group.centralMass = 1000;
  particles.groups = {group};
  particles.size = 0.2F;
  checkFramed(particles, {-3.1F, -0.1F, -3.1F}, {3.1F, 0.1F, 3.1F});
  particles.massExponent = 1.0F / 3;
  // The central body has 1000 times the mass of the others, so 10 times their radius.
  checkFramed(particles, {-3.1F, -1, -3.1F}, {3.1F, 1, 3.1F});
  particles.massExponent = 2.0F / 3;
  checkFramed(particles, {-10, -10, -10}, {10, 10, 10});
}

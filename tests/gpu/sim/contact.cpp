#include "gpu/context.hpp"
#include "reference/cloth_twin.hpp"
#include "reference/contact_twin.hpp"
#include "reference/crossings.hpp"
#include "reference/particles_twin.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/contact/lock_step.hpp"
#include "sim/core/collider.hpp"
#include "sim/grid/sheet_mesh.hpp"
#include "sim/mesh/shapes.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <doctest/doctest.h>
#include <glm/matrix.hpp>

using namespace simreel;

namespace {

sim::ClothParameters contactSheet(glm::ivec2 size, glm::vec3 position, glm::vec3 rotation) {
  sim::ClothParameters p;
  p.size = size;
  p.spacing = 0.03F;
  p.position = position;
  p.rotation = rotation;
  p.jitter = 2e-4F;
  p.fabric.emplace();
  p.wind = glm::vec3(0);
  p.damping = 0.3F;
  p.substeps = 9;
  p.pins.clear();
  p.contact.emplace();
  return p;
}

#define FUNCTION inline
#define precise
struct PlaceModel {
  using vec3 = glm::vec3;
  using vec4 = glm::vec4;
  static float exactFlush(float x) { return shader::exactFlush(x); }
#include "glsl/contact/place.glsl"
};
#undef precise
#undef FUNCTION

/// A mesh in rigid motion on the GPU, which also gives the CPU twin its vertex positions.
class MovedSolid : public sim::ContactSolid {
 public:
  using Place = glm::mat4 (*)(double time);
  MovedSolid(const sim::Mesh& mesh, Place place) : mesh_(mesh), place_(place) {
    for (const glm::vec3& p : mesh.positions) rest_.emplace_back(p, 1.0F);
    vertices_ = std::make_unique<sim::MovedVertices>("solid", rest_, false);
  }
  [[nodiscard]] sim::ContactPart contactPart() const override {
    std::vector<glm::vec3> positions;
    for (const glm::vec4& p : at(0, 0, 0)) positions.emplace_back(p);
    return sim::solidPart(positions, mesh_.indices, std::nullopt);
  }
  void step(double time, double frameSeconds) {
    vertices_->place(place_(time), place_(time + frameSeconds));
  }
  void moveTo(int substep, int substeps) override { vertices_->moveTo(substep, substeps); }
  [[nodiscard]] const gl::Vec4Array& now() const override { return vertices_->now(); }
  [[nodiscard]] const gl::Vec4Array& next() const override { return vertices_->next(); }
  /// Returns the vertices for the CPU twin, interpolated linearly between the positions at times `begin`
  /// and `end` with the fraction `share`.
  [[nodiscard]] std::vector<glm::vec4> at(double begin, double end, double share) const {
    const auto rows = [&](double time) {
      const glm::mat4 m = glm::transpose(place_(time));
      return PlaceModel::Placement{m[0], m[1], m[2]};
    };
    PlaceModel model;
    std::vector<glm::vec4> places;
    for (const glm::vec4& p : rest_)
      places.emplace_back(
          model.onTheWay(model.placedBy(rows(begin), glm::vec3(p)), model.placedBy(rows(end), glm::vec3(p)),
                         static_cast<float>(share)),
          0.0F);
    return places;
  }

 private:
  sim::Mesh mesh_;
  Place place_;
  std::vector<glm::vec4> rest_;
  std::unique_ptr<sim::MovedVertices> vertices_;
};

/// Links of simulations outside of a world. They contain only a group of simulations that step together,
/// with a fixed number of steps per frame.
class GroupAlone final : public sim::Links {
 public:
  explicit GroupAlone(int steps) : steps_(steps) {}
  [[nodiscard]] void* find(const sim::PortInfo&, std::string_view) const override { return nullptr; }
  [[nodiscard]] std::vector<void*> all(const sim::PortInfo&) const override { return {}; }
  [[nodiscard]] sim::GroupState together(const sim::PortInfo&) const override { return {true, steps_}; }
  [[nodiscard]] const sim::Simulation* simulation(std::string_view) const override { return nullptr; }
  [[nodiscard]] const scene::Object* declared(std::string_view) const override { return nullptr; }
  [[nodiscard]] double now() const override { return 0; }

 private:
  int steps_;
};

template <class T>
T* outletOf(sim::Simulation& simulation) {
  sim::Outlets outlets;
  simulation.connect(outlets);
  for (const sim::Outlets::Outlet& outlet : outlets.list)
    if (outlet.port == &T::port) return static_cast<T*>(outlet.find());
  return nullptr;
}

/// Steps the simulations and their CPU twins and compares every word of the state.
void compareContact(const std::vector<sim::ClothParameters>& sheets, int frames,
                    const std::vector<sim::ColliderShape>& colliders,
                    const std::vector<MovedSolid*>& solids = {},
                    const sim::ParticleParameters* particles = nullptr) {
  testContext();
  const double frameSeconds = 1.0 / 60.0;
  sim::Setting setting{false, 5, frameSeconds, &colliders};
  const GroupAlone links(*sheets.front().substeps);
  setting.links = &links;
  std::vector<std::unique_ptr<sim::Simulation>> cloths;
  std::vector<sim::LockStep*> members;
  std::vector<std::unique_ptr<ClothTwin>> twins;
  std::vector<sim::ContactPart> parts;
  for (const sim::ClothParameters& p : sheets) {
    scene::Object object;
    object.name = "sheet";
    object.kind = "cloth";
    object.parameters = std::make_unique<sim::ClothParameters>(p);
    cloths.push_back(sim::simulationNamed("cloth").make(object, setting));
    members.push_back(outletOf<sim::LockStep>(*cloths.back()));
    twins.push_back(std::make_unique<ClothTwin>(sim::ClothPlan(p, 5, frameSeconds, colliders)));
    parts.push_back(members.back()->contactPart());
  }
  std::unique_ptr<sim::Simulation> cloud;
  std::unique_ptr<ParticlesTwin> balls;
  if (particles != nullptr) {
    scene::Object object;
    object.name = "balls";
    object.kind = "particles";
    object.parameters = std::make_unique<sim::ParticleParameters>(*particles);
    cloud = sim::simulationNamed("particles").make(object, setting);
    members.push_back(outletOf<sim::LockStep>(*cloud));
    balls = std::make_unique<ParticlesTwin>(sim::ParticlePlan(
        particles->withContactSubsteps(*sheets.front().substeps), 5, frameSeconds, 1 << 10, colliders));
    parts.push_back(balls->plan().contactPart());
  }
  for (const MovedSolid* solid : solids) parts.push_back(solid->contactPart());
  sim::ContactGroup group(members, {solids.begin(), solids.end()}, *sheets.front().substeps, frameSeconds,
                          false);
  ContactTwin contact(sim::ContactPlan(parts, frameSeconds / *sheets.front().substeps));
  std::size_t touching = 0, stopped = 0, carried = 0;
  for (int frame = 0; frame < frames; ++frame) {
    const double time = frame * frameSeconds;
    for (MovedSolid* solid : solids) solid->step(time, frameSeconds);
    group.step(time, {});
    std::vector<std::vector<shader::ClothStep>> steps;
    for (const auto& twin : twins) steps.push_back(twin->plan().frame(frame * frameSeconds));
    if (balls) balls->beginFrame(time);
    for (std::size_t i = 0; i < steps.front().size(); ++i) {
      std::vector<ContactTwin::Part> sides;
      for (std::size_t c = 0; c < twins.size(); ++c) {
        twins[c]->predict(steps[c][i], 1, static_cast<int>(i));
        sides.push_back({&twins[c]->positions, &twins[c]->next, &twins[c]->velocities});
      }
      if (balls) {
        balls->predict(static_cast<int>(i));
        sides.push_back({&balls->starts, &balls->positions, &balls->velocities});
      }
      std::vector<std::vector<glm::vec4>> places;
      for (const std::size_t k : {i, i + 1})
        for (const MovedSolid* solid : solids)
          places.push_back(solid->at(time, time + frameSeconds,
                                     static_cast<double>(k) / static_cast<double>(steps.front().size())));
      for (std::size_t k = 0; k < solids.size(); ++k)
        sides.push_back({&places[k], &places[solids.size() + k], nullptr});
      contact.push(sides, i == 0);
      for (std::size_t c = 0; c < twins.size(); ++c) twins[c]->settle(steps[c][i], static_cast<int>(i));
      if (balls) balls->settle(static_cast<int>(i));
      contact.hold(sides);
      touching += contact.touching;
      stopped += contact.stopped;
      carried += contact.carried;
      for (const auto& twin : twins) twin->finish();
    }
  }
  CHECK(touching > 100);
  CHECK(stopped > 10);
  CHECK((carried > 10) == !solids.empty());
  for (std::size_t c = 0; c < members.size(); ++c) {
    const auto state = c < cloths.size() ? cloths[c]->state() : cloud->state();
    const std::vector<glm::vec4>* expected[] = {
        &(c < cloths.size() ? twins[c]->positions : balls->positions),
        &(c < cloths.size() ? twins[c]->velocities : balls->velocities)};
    for (std::size_t array = 0; array < 2; ++array) {
      const auto got = state[array].buffer->readAll<std::uint32_t>();
      REQUIRE(got.size() == expected[array]->size() * 4);
      std::size_t different = 0;
      for (std::size_t i = 0; i < got.size(); ++i)
        different +=
            got[i] == std::bit_cast<std::uint32_t>((*expected[array])[i / 4][static_cast<int>(i % 4)]) ? 0
                                                                                                       : 1;
      CHECK_MESSAGE(different == 0, "cloth ", c, " ", state[array].name, ": ", different, " of ",
                    got.size(), " words differ");
    }
  }
}

}  // namespace

TEST_CASE("cloths in contact equal their CPU twins, which try every pair") {
  sim::ColliderShape ball;
  ball.position = glm::vec3(0, 0.2F, 0);
  ball.radius = 0.15F;
  ball.friction = 0.3;
  sim::ColliderShape floor;
  floor.kind = sim::ColliderShape::Kind::plane;
  auto held = contactSheet({7, 5}, {0.1F, 0.34F, 0.05F}, {20, 70, 0});
  sim::PinGroup& pins = held.pins.emplace_back();
  pins.columns = {0};
  pins.move = scene::Animated<glm::vec3>({{0.0, glm::vec3(0)}, {0.5, glm::vec3(-0.1F, 0.1F, 0)}},
                                         scene::Ease::linear);
  compareContact({contactSheet({13, 11}, {0, 0.38F, 0}, {0, 0, 0}),
                  contactSheet({11, 15}, {0.02F, 0.42F, 0}, {0, 25, 0}), held},
                 30, {ball, floor});
}

TEST_CASE("a cloth in contact with itself equals its CPU twin") {
  auto p = contactSheet({5, 45}, {0, 0.9F, 0}, {85, 0, 0});
  p.contact->friction = 0.6F;
  p.contact->thickness = 0.012;
  p.fabric->material = sim::FabricMaterial::silk;
  sim::ColliderShape floor;
  floor.kind = sim::ColliderShape::Kind::plane;
  floor.friction = 0.4;
  compareContact({p}, 45, {floor});
}

namespace {

sim::ParticleParameters fallingBalls() {
  sim::ParticleParameters p;
  p.method = sim::GravityMethod::none;
  p.collides = true;
  p.margin = 0.02F;
  p.bounce = 0.4F;
  p.acceleration = glm::vec3(0, -9.8F, 0);
  sim::ParticleGroup& group = p.groups.emplace_back();
  group.shape = sim::ParticleGroup::Shape::cube;
  group.count = 9;
  group.radius = 0.12F;
  group.totalMass = 0.05F;
  group.position = glm::vec3(0.01F, 0.3F, 0);
  group.velocity = glm::vec3(0.1F, -2, 0);
  sim::Emitter& emitter = p.emitters.emplace_back();  // The particles are born and removed between and
                                                      // inside the sheets.
  emitter.rate = 55;
  emitter.lifetime = 0.15F;
  emitter.mass = 0.001F;
  emitter.radius = 0.05F;
  emitter.position = glm::vec3(0, 0.2F, 0.02F);
  emitter.velocity = glm::vec3(0, -3, 0);
  return p;
}

}  // namespace

TEST_CASE("particles that collide with cloths, with births and deaths, equal their CPU twins") {
  auto held = contactSheet({13, 11}, {0, 0.1F, 0}, {0, 0, 0});
  held.pins.emplace_back().columns = {0, -1};
  sim::ColliderShape floor;
  floor.kind = sim::ColliderShape::Kind::plane;
  floor.friction = 0.3;
  auto balls = fallingBalls();
  compareContact({held, contactSheet({7, 9}, {0.02F, 0.13F, 0}, {0, 25, 0})}, 14, {floor}, {}, &balls);
  balls.method = sim::GravityMethod::allPairs;  // The balls also attract each other.
  balls.gravity = 1e-4F;
  MovedSolid box(sim::planeMesh({0.3F, 0, 0.3F}, {3, 2}), [](double time) {
    glm::mat4 m(1);
    m[3].y = static_cast<float>(0.05 + 0.3 * time);
    return m;
  });
  compareContact({held}, 8, {floor}, {&box}, &balls);
}

TEST_CASE("cloths in contact with moving and static solids equal their CPU twins") {
  testContext();
  auto held = contactSheet({13, 11}, {0, 0.1F, 0}, {90, 0, 0});
  held.pins.emplace_back().rows = {0};
  held.contact->friction = 0.4F;
  MovedSolid ball(sim::sphereMesh(0.09F, {13, 8}), [](double time) {
    glm::mat4 m = sim::rotationMatrix({0, 0, static_cast<float>(700 * time)});
    m[3] = glm::vec4(0.02F, 0.05F, static_cast<float>(-0.2 + 6 * time), 1);
    return m;
  });
  MovedSolid floor(sim::planeMesh({0.9F, 0, 0.7F}, {3, 2}), [](double) {
    glm::mat4 m(1);
    m[3].y = -0.13F;
    return m;
  });
  compareContact({held, contactSheet({11, 9}, {0.05F, -0.11F, 0.1F}, {0, 25, 0})}, 9, {}, {&ball, &floor});
}

namespace {

/// Steps a scene whose first object is a cloth that touches the second object. Checks that no edge of one
/// object passes through a face of the other. Returns the minimum height of the cloth in the last frames.
float stepApart(const char* text, int frames) {
  testContext();
  const scene::Scene scene = scene::parseScene(text, "test.json", {}, sim::kinds());
  sim::World world(scene);
  float lowest = 1e9F;
  for (int frame = 0; frame <= frames; frame += 3) {
    world.advanceTo(frame);
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> faces;
    unsigned firstSolid = 0;
    for (std::size_t object = 0; object < 2; ++object) {
      firstSolid = static_cast<unsigned>(points.size());
      const auto mesh = world.object(object).mesh();
      REQUIRE(mesh);
      for (std::size_t i = 0; i + 2 < mesh->indices.size(); i += 3)
        faces.push_back(glm::uvec3(mesh->indices[i], mesh->indices[i + 1], mesh->indices[i + 2]) +
                        firstSolid);
      points.insert(points.end(), mesh->positions.begin(), mesh->positions.end());
      if (object == 0 && frame >= frames - 3)
        for (const glm::vec3& p : mesh->positions) lowest = std::min(lowest, p.y);
    }
    CHECK(crossings(points, faces, firstSolid) == 0);
  }
  return lowest;
}

}  // namespace

TEST_CASE("a sheet falls onto a waving mesh and a moving mesh without crossing it") {
  const float waving = stepApart(R"({"version": 1, "objects": {
    "sheet": {"cloth": {"size": [13, 11], "spacing": 0.05, "position": [0, 0.12, 0], "fabric": "cotton", "contact": true, "pins": []}},
    "sea": {"mesh": {"shape": "plane", "size": [1.2, 0, 1.2], "resolution": [17, 15], "collides": "faces", "friction": 0.5,
                     "deform": [{"waves": [{"amplitude": 0.04, "length": 0.6, "speed": 1, "steepness": 0.5}]}]}}}})",
                                 30);
  CHECK(waving > -0.06F);
  CHECK(waving < 0.1F);
  const float moved = stepApart(R"({"version": 1, "time": {"start": 0.1}, "objects": {
    "sheet": {"cloth": {"size": [13, 11], "spacing": 0.05, "position": [0, 0.35, 0], "fabric": "cotton", "contact": {}, "pins": []}},
    "ring": {"mesh": {"shape": "torus", "radius": 0.2, "tube": 0.07, "resolution": [21, 9], "collides": "faces",
                      "position": {"keys": [[0, [0, 0, 0]], [0.5, [0.1, 0.6, 0]]]},
                      "rotation": {"keys": [[0, [60, 0, 0]], [0.5, [90, 0, 90]]]}}}}})",
                                30);
  CHECK(moved > -0.2F);  // The ring lifts the sheet, which would otherwise fall to -0.9 m.
}

TEST_CASE("a sheet falls onto a walking figure without crossing its skin") {
  const float lowest = stepApart(R"({"version": 1, "time": {"start": 0.2}, "objects": {
    "sheet": {"cloth": {"size": [17, 15], "spacing": 0.05, "position": [0, 1.85, 0.1], "fabric": "cotton", "contact": true, "pins": []}},
    "walker": {"body": {"file": "meshes/walker.gltf", "animation": "walk", "collides": "faces", "friction": 0.4}}}})",
                                 24);
  CHECK(lowest > 1.2F);
}

TEST_CASE("a mesh disc falls onto a hanging sheet without crossing it") {
  testContext();
  const scene::Scene scene = scene::parseScene(R"({"version": 1, "objects": {
    "sheet": {"cloth": {"size": [17, 15], "spacing": 0.05, "fabric": "canvas", "contact": {},
                        "pins": [{"corners": ["top-left", "top-right", "bottom-left", "bottom-right"]}]}},
    "disc": {"cloth": {"mesh": {"shape": "disc", "radius": 0.25, "resolution": [11, 11]}, "position": [0.03, 0.15, 0.02],
                       "rotation": [20, 10, 0], "fabric": "silk", "contact": {}, "pins": []}}}})",
                                               "test.json", {}, sim::kinds());
  sim::World world(scene);
  CHECK(world.object(0).stepsPerFrame() == world.object(1).stepsPerFrame());
  double lowest = 0;
  for (int frame = 0; frame <= 36; frame += 3) {
    world.advanceTo(frame);
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> faces;
    for (std::size_t object = 0; object < 2; ++object) {
      const auto first = static_cast<unsigned>(points.size());
      const auto mesh = world.object(object).mesh();
      REQUIRE(mesh);
      for (std::size_t i = 0; i + 2 < mesh->indices.size(); i += 3)
        faces.push_back(glm::uvec3(mesh->indices[i], mesh->indices[i + 1], mesh->indices[i + 2]) + first);
      points.insert(points.end(), mesh->positions.begin(), mesh->positions.end());
      if (object == 1)
        for (const glm::vec3& p : mesh->positions) lowest = std::min<double>(lowest, p.y);
    }
    CHECK(crossings(points, faces) == 0);
  }
  CHECK(lowest > -0.6);  // The sheet holds up the disc, which would otherwise fall 1.8 m in 0.6 s.
  CHECK(lowest < -0.05);
}

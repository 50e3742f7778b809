// Tests deformed meshes. Compares every technique with the CPU twin word by word, and the pictures of all
// techniques with each other.
#include "draw/screen/readback.hpp"
#include "draw/screen/renderer.hpp"
#include "gpu/context.hpp"
#include "gpu/sim/words.hpp"
#include "scene/load.hpp"
#include "sim/mesh/deform_cpu.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <cstdint>
#include <cstdlib>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

const char* const techniques[] = {"compute", "single-thread", "jobs", "mapped", "vertex-shader"};

const char* const everything = R"([
  {"ripple": {"amplitude": 0.1, "wavelength": 1.7, "decay": 0.2, "centre": [0.3, 0, 0.1]}},
  {"waves": [{"direction": 33, "length": 1.1, "amplitude": 0.06}, {"direction": 120, "length": 2.3, "amplitude": 0.08}]},
  {"sway": {"height": 0.4, "base": -0.2}},
  {"footprints": {"cells": [67, 51], "depth": 0.3}},
  {"push": {"softness": 0.2}}])";

/// Returns a scene with one mesh, and a ball and a rod that touch the mesh.
scene::Scene sceneOf(const std::string& mesh, const std::string& deform, const std::string& technique,
                     const std::string& more = "") {
  const std::string text = fmt::format(
      R"({{"version": 1, "camera": {{"position": [1.5, 2, 4], "target": [0, 0, 0]}}, {2}
      "objects": {{
        "mesh": {{"mesh": {{{0}, "deform": {1}, "technique": "{3}"}}, "material": {{"roughness": 0.5}}}},
        "ball": {{"sphere": {{"radius": 0.4, "position": {{"keys": [[0, [-1, 0.2, 0]], [1, [1, 0.1, 0.4]]]}}}}}},
        "rod": {{"capsule": {{"radius": 0.2, "length": 0.7, "rotation": [0, 20, 80], "position": [0.2, 0.1, -0.8]}}}}
      }}}})",
      mesh, deform, more, technique);
  return scene::parseScene(text, "test.json", {}, sim::kinds());
}

using Words = std::vector<std::vector<std::uint32_t>>;

Words stateAfter(const std::string& mesh, const std::string& deform, const std::string& technique,
                 int frames) {
  sim::World world(sceneOf(mesh, deform, technique));
  world.advanceTo(frames);
  Words words;
  for (const sim::StateArray& array : world.object(0).state())
    words.push_back(array.buffer->readAll<std::uint32_t>());
  return words;
}

/// Returns the CPU twin's positions, followed by its trail.
std::vector<std::vector<glm::vec4>> twinAfter(const std::string& mesh, const std::string& deform,
                                              int frames) {
  const scene::Scene scene = sceneOf(mesh, deform, "compute");
  const auto& parameters = dynamic_cast<const sim::MeshParameters&>(*scene.objects[0].parameters);
  std::vector<sim::ColliderShape> colliders(2);
  colliders[0].radius = 0.4F;
  colliders[0].position = scene::Animated<glm::vec3>(
      {{0.0, glm::vec3(-1, 0.2F, 0)}, {1.0, glm::vec3(1, 0.1F, 0.4F)}}, scene::Ease::linear);
  colliders[1].kind = sim::ColliderShape::Kind::capsule;
  colliders[1].radius = 0.2F;
  colliders[1].length = 0.7F;
  colliders[1].rotation = glm::vec3(0, 20, 80);
  colliders[1].position = glm::vec3(0.2F, 0.1F, -0.8F);
  const sim::Mesh shape = parameters.make(1);
  const sim::DeformPlan plan("mesh", parameters, shape, colliders);
  const sim::RestMesh rest("mesh", shape);
  sim::DeformCpu cpu(rest, plan.trailCells());
  for (int frame = 1; frame <= frames; ++frame)
    if (plan.hasTrail()) {
      const double now = (frame - 1) / 60.0 + 1.0 / 60.0;
      cpu.press(plan.swept(now - 1.0 / 60.0, now), sim::Threads::one);
    }
  cpu.displace(plan.at((frames - 1) / 60.0 + 1.0 / 60.0), sim::Threads::one);
  if (!plan.hasTrail()) return {cpu.positions()};
  return {cpu.positions(), cpu.trail()};
}

std::vector<std::uint8_t> picture(const scene::Scene& scene, int frame) {
  const glm::ivec2 size(640, 360);
  sim::World world(scene);
  world.advanceTo(frame);
  draw::Renderer renderer(scene, size, 4);
  renderer.draw(world.time(), world.drawables());
  draw::Readback readback(size);
  readback.start(renderer.target(), 0);
  return readback.nextPicture(true)->second;
}

/// Returns the fraction of pixels with a channel that differs by more than 2.
double differingFraction(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  REQUIRE(a.size() == b.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); i += 4) {
    int max = 0;
    for (std::size_t k = 0; k < 4; ++k) max = std::max(max, std::abs(int{a[i + k]} - int{b[i + k]}));
    count += max > 2 ? 1 : 0;
  }
  return static_cast<double>(count) / (static_cast<double>(a.size()) / 4);
}

}  // namespace

TEST_CASE("deform: every technique with a state equals its CPU twin") {
  testContext();
  for (const char* mesh :
       {R"("shape": "plane", "resolution": [131, 87])",
        R"("shape": "torus", "resolution": [53, 31], "rotation": [20, 0, 0], "scale": 0.8)",
        R"("shape": "grass", "size": [2, 0, 2], "blades": 333)"}) {
    const auto expected = twinAfter(mesh, everything, 23);
    double moved = 0;
    for (const glm::vec4& cell : expected[1]) moved += cell.x;
    CHECK(moved > 0.1);  // The displacement shows that there are footprints.
    for (const char* technique : {"compute", "single-thread", "jobs", "mapped"}) {
      const Words words = stateAfter(mesh, everything, technique, 23);
      REQUIRE(words.size() == 2);
      CHECK_MESSAGE(wordsUnlike(words[0], expected[0]) == 0, technique, " positions of ", mesh);
      CHECK_MESSAGE(wordsUnlike(words[1], expected[1]) == 0, technique, " trail of ", mesh);
    }
    const Words late = stateAfter(mesh, everything, "vertex-shader", 23);
    REQUIRE(late.size() == 1);
    CHECK(wordsUnlike(late[0], expected[1]) == 0);
  }
}

TEST_CASE(
    "deform: 401x401 vertices with sixteen displacements equal the CPU in spite of the loop limits of "
    "software drivers") {
  testContext();
  std::string waves;
  for (int i = 0; i < 16; ++i)
    waves += fmt::format(R"({}{{"direction": {}, "length": {}, "amplitude": 0.01}})", i == 0 ? "" : ",",
                         21 * i, 0.5 + 0.1 * i);
  const std::string deform = "[{\"waves\": [" + waves + "]}]";
  const char* mesh = R"("shape": "plane", "resolution": [401, 401])";
  const auto expected = twinAfter(mesh, deform, 1);
  CHECK(wordsUnlike(stateAfter(mesh, deform, "compute", 1)[0], expected[0]) == 0);
}

TEST_CASE("deform: baked meshes are identical for all techniques and equal the readback") {
  testContext();
  const char* mesh = R"("shape": "sphere", "resolution": [37, 23], "position": [0, 0.5, 0])";
  const auto tableOf = [&](const std::string& technique) {
    sim::World world(sceneOf(mesh, everything, technique));
    world.advanceTo(7);
    return *world.object(0).mesh();
  };
  const sim::MeshTable expected = tableOf("single-thread");
  CHECK(expected.indices.size() == 36 * 22 * 6);
  for (const std::string technique :
       {"jobs", "mapped", "compute", "vertex-shader", "compute\", \"readback\": true, \"sides\": \"one"}) {
    const sim::MeshTable got = tableOf(technique);
    CHECK_MESSAGE(got.positions == expected.positions, technique);
    CHECK_MESSAGE(got.normals == expected.normals, technique);
    CHECK(got.uvs == expected.uvs);
  }
}

TEST_CASE(
    "deform: after 1,000 frames, time 0 gives the same bits, because the rest shape is never overwritten") {
  testContext();
  scene::Object object;
  object.name = "sheet";
  auto parameters = std::make_unique<sim::MeshParameters>();
  parameters->resolution = {19, 13};
  parameters->deform.list.resize(1);
  parameters->deform.list[0].ripple.on = true;
  object.parameters = std::move(parameters);
  const std::vector<sim::ColliderShape> none;
  for (const auto technique : {sim::DeformTechnique::compute, sim::DeformTechnique::mapped}) {
    dynamic_cast<sim::MeshParameters&>(*object.parameters).deform.technique = technique;
    const auto sheet = sim::simulationNamed("mesh").make(object, {false, 1, 1.0 / 60.0, &none});
    sheet->step(-1.0 / 60.0, {});
    const auto first = sheet->state()[0].buffer->readAll<std::uint32_t>();
    for (int frame = 0; frame < 1000; ++frame) sheet->step(frame / 60.0, {});
    CHECK(sheet->state()[0].buffer->readAll<std::uint32_t>() != first);
    sheet->step(-1.0 / 60.0, {});
    CHECK(sheet->state()[0].buffer->readAll<std::uint32_t>() == first);
  }
}

TEST_CASE("deform: frames that are not drawn are not displaced and do not change later frames") {
  testContext();
  const auto hashOf = [](sim::World& world) {
    world.startSummary();
    return world.takeSummary(true)->stateHash;
  };
  for (const std::string technique : techniques) {
    CAPTURE(technique);
    const scene::Scene scene =
        sceneOf(R"("shape": "plane", "resolution": [61, 47])", everything, technique);
    sim::World whole(scene);
    sim::World passed(scene);
    whole.advanceTo(9);
    passed.advanceUndrawn(9);
    const std::string ninth = hashOf(whole);
    // The technique "vertex-shader" stores no positions, so the hash of its state does not change.
    if (technique != "vertex-shader") CHECK(hashOf(passed) != ninth);
    passed.complete();
    CHECK(hashOf(passed) == ninth);
    whole.advanceTo(13);
    passed.advanceUndrawn(12);
    passed.advanceTo(13);
    CHECK(hashOf(passed) == hashOf(whole));
  }
}

TEST_CASE("deform: all five techniques draw the same picture") {
  testContext();
  struct Case {
    const char* mesh;
    const char* deform;
  };
  const char* scenery = R"("stage": false, "ground": {"height": -0.6},)";
  for (const Case& c : {Case{R"("shape": "plane", "resolution": [101, 101])",
                             R"([{"ripple": {"amplitude": 0.15, "wavelength": 1.5}}])"},
                        Case{R"("shape": "torus", "resolution": [81, 41])",
                             R"([{"waves": [{"length": 1.5, "amplitude": 0.05}]}])"},
                        Case{R"("shape": "plane", "resolution": [131, 131])",
                             R"([{"footprints": {"cells": [101, 101], "depth": 0.2}}])"}}) {
    const auto expected = picture(sceneOf(c.mesh, c.deform, "single-thread", scenery), 20);
    const auto flat = picture(sceneOf(c.mesh, "[]", "compute", scenery), 20);
    CHECK(differingFraction(flat, expected) > 0.01);  // The difference shows that the deformation is
                                                      // visible.
    for (const char* technique : techniques) {
      const double fraction =
          differingFraction(picture(sceneOf(c.mesh, c.deform, technique, scenery), 20), expected);
      CHECK_MESSAGE(fraction <= 0.001, technique, " of ", c.deform, ": ", fraction);
    }
  }
}

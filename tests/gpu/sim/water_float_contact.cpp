// Tests floats that touch each other. The GPU must equal the CPU twin bit for bit.
#include "gpu/context.hpp"
#include "reference/water_twin.hpp"
#include "sim/water/water.hpp"

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr double crowdFrame = 1.0 / 30;

/// Returns floats that are close enough to touch: a wedge, two boxes, a ball, and a sphere inside a box.
sim::WaterParameters crowd(const std::filesystem::path& wedge, glm::ivec2 size) {
  sim::WaterParameters p;
  p.size = size;
  p.cell = 0.11F;
  p.bed = -0.9F;
  p.greatestSpeed = 4;
  sim::WaterFloat body;
  body.shape = sim::WaterFloatShape::file;
  body.file = wedge;
  body.position = {-0.35F, 0.05F, 0.1F};
  body.velocity = {1.4F, 0, 0.2F};
  body.spin = {20, 60, -30};
  p.floats.push_back(body);
  body = {};
  body.shape = sim::WaterFloatShape::box;
  body.size = {0.3F, 0.25F, 0.55F};
  body.position = {0.15F, 0.05F, 0};
  body.rotation = {10, 20, 5};
  body.thrust = 30.0F;
  p.floats.push_back(body);
  body.position = {0.2F, 0.42F, 0.1F};
  body.rotation = {0, 70, 12};
  body.density = 250;
  p.floats.push_back(body);
  body.position = {-0.1F, 0.3F, -0.5F};
  body.apart = 0.2;
  p.floats.push_back(body);
  body = {};
  body.radius = 0.17F;
  body.position = {0.45F, 0.5F, 0.05F};
  p.floats.push_back(body);
  return p;
}

template <class Texel>
int crowdDiffers(const std::vector<Texel>& a, const std::vector<Texel>& b) {
  int different = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    for (int c = 0; c < 4; ++c)
      different += std::bit_cast<std::uint32_t>(a[i][c]) != std::bit_cast<std::uint32_t>(b[i][c]) ? 1 : 0;
  return different;
}

}  // namespace

TEST_CASE("water with floats in contact equals its CPU twin, also across the seam of a torus") {
  testContext();
  const auto file = std::filesystem::temp_directory_path() / "simreel_float_wedge.obj";
  std::ofstream(file) << "v -0.2 0.15 -0.3\nv 0.2 0.15 -0.3\nv 0.2 0.15 0.3\nv -0.2 0.15 0.3\n"
                         "v 0 -0.15 -0.25\nv 0 -0.15 0.2\n"
                         "f 1 4 3\nf 1 3 2\nf 1 2 5\nf 4 6 3\nf 2 3 6\nf 2 6 5\nf 1 5 6\nf 1 6 4\n";
  for (const bool torus : {false, true}) {
    CAPTURE(torus);
    auto p = crowd(file, torus ? glm::ivec2(19, 23) : glm::ivec2(21, 17));
    if (torus) {
      p.sides.fill(sim::WaterBorder::periodic);
      for (sim::WaterFloat& body : p.floats) body.position.x += body.position.x < 0 ? 1 : -1;
      p.floats[0].position.x = 0.85F;
      p.floats[1].position.x = -0.85F;
    }
    scene::Object object;
    object.name = "pond";
    object.kind = "water";
    object.parameters = std::make_unique<sim::WaterParameters>(p);
    const std::vector<sim::ColliderShape> none;
    const auto gpu = sim::waterKind().make(object, {false, 5, crowdFrame, &none});
    WaterTwin twin(sim::WaterPlan(p, "pond", 5, crowdFrame));
    for (int frame = 0; frame < 8; ++frame) {
      gpu->step(frame * crowdFrame, {});
      twin.step(frame * crowdFrame);
    }
    CHECK(crowdDiffers(gpu->state()[0].buffer->readAll<glm::vec4>(), twin.cells) == 0);
    CHECK(crowdDiffers(gpu->state()[1].buffer->readAll<glm::vec4>(), twin.floats) == 0);
    CHECK(crowdDiffers(gpu->state()[2].buffer->readAll<glm::ivec4>(), twin.displaced) == 0);
    // The bodies must have collided: the first one has not travelled freely.
    if (!torus) CHECK(twin.floats[2].x < 1.0F);
  }
  std::filesystem::remove(file);
}

// Tests trails of particles by comparison with the positions in earlier frames.
#include "sim/particles/trails.hpp"

#include "gpu/context.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

constexpr int particles = 5, frames = 4, points = frames + 1, rings = points + 2;

glm::vec3 placeOf(int particle, int frame) {
  const auto p = static_cast<float>(particle), f = static_cast<float>(frame);
  return {p + 0.1F * f, 0.3F * p * f, 0.05F * f * f};
}

/// Centre and radius of a ring of a tube.
struct Ring {
  glm::vec3 middle{0};
  float radius = 0;
};

Ring ringOf(const sim::MeshTable& table, int trail, int ring) {
  const auto first = static_cast<std::size_t>((trail * rings + ring) * sim::Tubes::sides);
  Ring found;
  for (std::size_t i = 0; i < sim::Tubes::sides; ++i)
    found.middle += table.positions[first + i] / static_cast<float>(sim::Tubes::sides);
  for (std::size_t i = 0; i < sim::Tubes::sides; ++i)
    found.radius = std::max(found.radius, glm::distance(table.positions[first + i], found.middle));
  return found;
}

/// Returns the trails of every second particle. `ageAt` returns the age of a particle in a frame.
template <class AgeAt>
sim::MeshTable trailsAfter(int last, const AgeAt& ageAt) {
  testContext();
  static const scene::Material material;
  sim::Instances look;
  sim::ParticleTrails trails("dust", {.frames = frames, .width = 0.02F, .every = 2}, particles, look,
                             material, false);
  for (int frame = 0; frame <= last; ++frame) {
    std::vector<glm::vec4> places, velocities;
    for (int i = 0; i < particles; ++i) {
      places.emplace_back(placeOf(i, frame), 1);
      velocities.emplace_back(0, 0, 0, ageAt(i, frame));
    }
    const gl::Vec4Array at("places", places), moving("velocities", velocities);
    trails.record(at, moving);
    if (frame == last) static_cast<void>(trails.surface(at, moving));
  }
  return trails.table();
}

}  // namespace

TEST_CASE("trails go through the places of earlier frames and narrow to their end") {
  const sim::MeshTable table = trailsAfter(11, [](int, int) { return 0.0F; });
  REQUIRE(table.positions.size() == 3 * rings * sim::Tubes::sides);
  for (int trail = 0; trail < 3; ++trail)
    for (int back = 0; back < points; ++back) {
      CAPTURE(trail);
      CAPTURE(back);
      const Ring ring = ringOf(table, trail, 1 + back);
      CHECK(glm::distance(ring.middle, placeOf(2 * trail, 11 - back)) < 1e-5F);
      CHECK(ring.radius == doctest::Approx(0.01 * (frames - back) / frames).epsilon(1e-4));
    }
}

TEST_CASE("a trail of few frames ends at the first one") {
  const sim::MeshTable table = trailsAfter(2, [](int, int) { return 0.0F; });
  for (int back = 0; back < points; ++back)
    CHECK(glm::distance(ringOf(table, 1, 1 + back).middle, placeOf(2, std::max(0, 2 - back))) < 1e-5F);
}

TEST_CASE("a trail begins where its particle was born") {
  // Particle 0 lives in all frames. Particle 2 is born in frame 9 in the slot of a particle that died.
  // Particle 4 does not live.
  const sim::MeshTable table = trailsAfter(11, [](int i, int frame) {
    if (i == 4) return -1.0F;
    return i == 0      ? 0.05F * static_cast<float>(frame)
           : frame < 9 ? 0.9F
                       : 0.1F * static_cast<float>(frame - 8);
  });
  for (int back = 0; back < points; ++back) {
    CHECK(glm::distance(ringOf(table, 0, 1 + back).middle, placeOf(0, 11 - back)) < 1e-5F);
    CHECK(glm::distance(ringOf(table, 1, 1 + back).middle, placeOf(2, std::max(9, 11 - back))) < 1e-5F);
    const Ring dead = ringOf(table, 2, 1 + back);
    CHECK(glm::distance(dead.middle, placeOf(4, 11)) < 1e-5F);
    CHECK(dead.radius < 1e-5F);  // The tolerance covers rounding of the middle.
  }
}

#include "gpu/draw/exact/stage.hpp"
#include "reference/raster_twin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;  // NOLINT

namespace {

constexpr unsigned noKey = 0xffffffffU;

/// Generator of uniform random numbers in (low, high) that are the same with every standard library.
class MeshDice {
 public:
  explicit MeshDice(unsigned seed) : engine_(seed) {}
  float operator()(float low, float high) {
    return low + (high - low) * static_cast<float>(engine_() >> 8U) * 0x1p-24F;
  }
  glm::vec3 place(glm::vec3 low, glm::vec3 high) {
    const float x = (*this)(low.x, high.x);
    const float y = (*this)(low.y, high.y);
    return {x, y, (*this)(low.z, high.z)};
  }

 private:
  std::mt19937 engine_;
};

struct TriangleSoup {
  std::vector<glm::vec3> places;
  std::vector<unsigned> indices;
  void add(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    for (const glm::vec3& p : {a, b, c}) {
      indices.push_back(static_cast<unsigned>(places.size()));
      places.push_back(p);
    }
  }
};

/// Returns small triangles, slivers, triangles as large as the picture, triangles around and behind the eye
/// (at z = 5, facing -z), and degenerate ones.
TriangleSoup soup(unsigned seed) {
  MeshDice dice(seed);
  TriangleSoup all;
  // Triangle 0 is invisible, because uninitialized memory may contain the id 0. The first visible triangle
  // comes from the lists below.
  all.add({0, 0, 0}, {0, 0, 0}, {1, 0, 0});
  all.add({-0.05F, -0.05F, 4.2F}, {0.05F, -0.05F, 4.2F}, {0, 0.05F, 4.2F});
  for (int i = 0; i < 300; ++i) {
    const glm::vec3 middle = dice.place({-3, -2, -4}, {3, 2, 3});
    const float reach = i % 3 == 0 ? 0.05F : 0.5F;
    const auto corner = [&] { return middle + dice.place(glm::vec3(-reach), glm::vec3(reach)); };
    const glm::vec3 a = corner();
    const glm::vec3 b = corner();
    all.add(a, b, i % 7 == 0 ? a + (b - a) * 0.4F + glm::vec3(0, 1e-4F, 0) : corner());
  }
  for (int i = 0; i < 40; ++i)
    all.add(dice.place({-30, -30, -30}, {30, 30, 12}), dice.place({-30, -30, -30}, {30, 30, 12}),
            dice.place({-30, -30, -30}, {30, 30, 12}));
  all.add({0, 0, 0}, {1, 1, 0}, {2, 2, 0});
  return all;
}

/// Returns the position of a sample within its pixel (pixels), from the documented pattern instead of the
/// shader's packed constants.
glm::dvec2 fourSamples(int s) {
  constexpr std::array<glm::dvec2, 4> places = {
      glm::dvec2{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
  return places[static_cast<std::size_t>(s)];
}

}  // namespace

TEST_CASE("exact: what triangles show is what the twin says, small ones alone or in tiles") {
  const TriangleSoup all = soup(3);
  for (const int samples : {1, 2, 4, 8, 16}) {
    for (const bool doubleSided : {true, false}) {
      const auto view = exactViewFrom({0, 0, 5}, {0.2F, -0.1F, 0}, {101, 67});
      TriangleStage stage(all.places, all.indices);
      stage.surface.doubleSided = doubleSided;
      const auto twin = rasterTwin(view, samples, doubleSided, all.places, all.indices);
      CAPTURE(samples);
      for (const int fanRoom : {1000, 101, 0}) {
        CAPTURE(fanRoom);
        const SeenSamples tiles = seenBy(view, samples, {&stage.surface}, 0, fanRoom, 0, 0);
        CHECK(tiles.keys == twin.keys);
        CHECK(tiles.ids == twin.ids);
      }
      // Values of the max number of triangles that are binned by tile: none, one, some, and all.
      for (const int binRoom : {0, 1, 40, 1 << 20}) {
        CAPTURE(binRoom);
        const SeenSamples small =
            seenBy(view, samples, {&stage.surface}, 64, binRoom == 40 ? 3 : 1000, 0, binRoom);
        CHECK(small.keys == twin.keys);
        CHECK(small.ids == twin.ids);
      }
    }
  }
}

TEST_CASE(
    "exact: what triangles show is the same by sixteen invocations each, and however samples lie in "
    "memory") {
  const TriangleSoup all = soup(3);
  for (const int samples : {1, 2, 4, 8, 16}) {
    const auto view = exactViewFrom({0, 0, 5}, {0.2F, -0.1F, 0}, {101, 67});
    TriangleStage stage(all.places, all.indices);
    stage.surface.doubleSided = true;
    const auto twin = rasterTwin(view, samples, true, all.places, all.indices);
    CAPTURE(samples);
    for (const char* word : LayoutForced::words()) {
      CAPTURE(word);
      const LayoutForced layout(word);
      for (const auto& [smallPixels, mediumPixels] : {std::pair(64, 0), {0, 64}, {3, 21}}) {
        CAPTURE(mediumPixels);
        const SeenSamples seen = seenBy(view, samples, {&stage.surface}, smallPixels, 1000, mediumPixels);
        CHECK(seen.keys == twin.keys);
        CHECK(seen.ids == twin.ids);
      }
    }
  }
}

TEST_CASE("exact: on a large picture, too, whose triangles reach far beyond it") {
  const TriangleSoup all = soup(4);
  const auto view = exactViewFrom({0, 0, 5}, {0.1F, -0.1F, 0}, {3001, 1043});
  TriangleStage stage(all.places, all.indices);
  stage.surface.doubleSided = true;
  const auto twin = rasterTwin(view, 1, true, all.places, all.indices);
  const SeenSamples seen = seenBy(view, 1, {&stage.surface}, 64);
  CHECK(seen.keys == twin.keys);
  CHECK(seen.ids == twin.ids);
}

TEST_CASE(
    "exact: a picture full of triangles that share edges shows no hole, and each sample one of them") {
  // An irregular mesh of triangles at one depth that covers the whole picture. At equal depth, the lower id
  // wins. A second mesh with the same triangles in reverse order therefore reveals every sample that two
  // triangles cover.
  constexpr int side = 23;
  MeshDice dice(11);
  std::vector<glm::vec3> places;
  for (int y = 0; y <= side; ++y)
    for (int x = 0; x <= side; ++x) {
      const bool border = x == 0 || y == 0 || x == side || y == side;
      const auto at = [&](int i) {
        return (static_cast<float>(i) / side - 0.5F) * 8 + (border ? 0 : dice(-0.08F, 0.08F));
      };
      const float u = at(x);
      places.emplace_back(u, at(y), 0.0F);
    }
  std::vector<unsigned> indices;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto i = static_cast<unsigned>(y * (side + 1) + x);
      indices.insert(indices.end(), {i, i + 1, i + side + 1, i + 1, i + side + 2, i + side + 1});
    }
  std::vector<unsigned> backwards;
  for (std::size_t i = indices.size(); i > 0; i -= 3)
    backwards.insert(backwards.end(), {indices[i - 3], indices[i - 2], indices[i - 1]});
  const auto view = exactViewFrom({0, 0, 5}, {0, 0, 0}, {127, 71});
  TriangleStage forth(places, indices);
  TriangleStage back(places, backwards);
  forth.surface.doubleSided = back.surface.doubleSided = true;
  const SeenSamples seen = seenBy(view, 4, {&forth.surface}, 16);
  const SeenSamples turned = seenBy(view, 4, {&back.surface}, 16);
  const auto count = static_cast<unsigned>(indices.size() / 3);
  CHECK(std::count(seen.ids.begin(), seen.ids.end(), noKey) == 0);
  int claimedTwice = 0;
  for (std::size_t i = 0; i < seen.ids.size(); ++i)
    claimedTwice += seen.ids[i] != count - 1 - turned.ids[i] ? 1 : 0;
  CHECK(claimedTwice == 0);
}

TEST_CASE(
    "exact: the nearest triangle at each sample is the one that a ray meets first, in double precision") {
  const TriangleSoup all = soup(5);
  const glm::ivec2 size(93, 61);
  const auto view = exactViewFrom({0, 0, 5}, {0, 0, 0}, size);
  TriangleStage stage(all.places, all.indices);
  stage.surface.doubleSided = true;
  const SeenSamples seen = seenBy(view, 4, {&stage.surface}, 16);
  const double high = std::tan(20 * 3.14159265358979 / 180);
  const double wide = high * size.x / size.y;
  int others = 0;
  int hits = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (int s = 0; s < 4; ++s) {
        const glm::dvec2 at = (glm::dvec2(x, y) + fourSamples(s)) / glm::dvec2(size) * 2.0 - 1.0;
        const glm::dvec3 ray(at.x * wide, -at.y * high, -1);
        double nearest = 200;
        unsigned expectedId = noKey;
        for (std::size_t i = 0; i + 2 < all.places.size(); i += 3) {
          // Intersection test of Moeller and Trumbore 1997.
          const glm::dvec3 a(all.places[i]);
          const glm::dvec3 ab = glm::dvec3(all.places[i + 1]) - a;
          const glm::dvec3 ac = glm::dvec3(all.places[i + 2]) - a;
          const glm::dvec3 p = glm::cross(ray, ac);
          const double det = glm::dot(ab, p);
          if (std::abs(det) < 1e-14) continue;
          const glm::dvec3 from = glm::dvec3(0, 0, 5) - a;
          const double u = glm::dot(from, p) / det;
          const glm::dvec3 q = glm::cross(from, ab);
          const double v = glm::dot(ray, q) / det;
          const double t = glm::dot(ac, q) / det;
          if (u < 0 || v < 0 || u + v > 1 || t < 0.05 || t >= nearest) continue;
          nearest = t;
          expectedId = static_cast<unsigned>(i / 3);
        }
        const auto i = static_cast<std::size_t>((y * size.x + x) * 4 + s);
        hits += expectedId != noKey ? 1 : 0;
        others += seen.ids[i] != expectedId ? 1 : 0;
        if (seen.ids[i] == expectedId && expectedId != noKey) {
          const double depth =
              0.05 /
              static_cast<double>(shader::intBitsToFloat(static_cast<int>(0x7fffffffU - seen.keys[i])));
          CHECK(std::abs(depth - nearest) < 2e-3 * nearest);
        }
      }
  CHECK(hits > 10000);
  // Corners are rounded to 1/256 pixel, so a sample very close to an edge may be on the wrong side.
  CHECK(others < hits / 100);
}

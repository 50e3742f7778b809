// Tests that rays find the same hits in a hierarchy as in a loop over all items, bit by bit.
#include "draw/exact/rays/hierarchy.hpp"

#include "draw/exact/rays/ray_kernels.hpp"
#include "draw/exact/visibility.hpp"
#include "gl/element_array.hpp"
#include "gpu/context.hpp"
#include "reference/ray_twin.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <random>
#include <vector>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

using namespace simreel;  // NOLINT

namespace {

struct TracedRay {
  glm::vec3 origin, along;
  float far = 1e9F;
};

#include "glsl/draw/exact/rays/look_table.glsl"

/// Triangles or balls on the GPU, with their hierarchy. The first corner of a ball holds centre and radius.
class HierarchyStage {
 public:
  HierarchyStage(const std::vector<glm::vec4>& places, bool balls)
      : balls_(balls), hierarchy_(balls ? draw::Hierarchy::Of::balls : draw::Hierarchy::Of::triangles) {
    testContext();
    places_ = gl::Buffer::of<glm::vec4>("places", places);
    std::vector<unsigned> corners(places.size());
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<unsigned>(i);
    corners_ = gl::Buffer::of<unsigned>("corners", corners);
    words_ = gl::Buffer("words", 16 * places.size());
    ballLooks_ = gl::Buffer("looks of balls", 16 * places.size());
    std::vector<glm::uvec4> look(static_cast<std::size_t>(lookTexels), glm::uvec4(0));
    look[static_cast<std::size_t>(fallbackMaterial)] = glm::uvec4(std::bit_cast<unsigned>(1.0F));
    looks_ = gl::Buffer::of<glm::uvec4>("looks", look);
    placeView_ = gl::Texture::view("places", GL_RGBA32F, places_);
    cornerView_ = gl::Texture::view("corners", GL_R32UI, corners_, 4);
    wordView_ = gl::Texture::view("words", GL_RGBA32UI, words_);
    ballLookView_ = gl::Texture::view("looks of balls", GL_RGBA32F, ballLooks_);
    lookView_ = gl::Texture::view("looks", GL_RGBA32UI, looks_);
    const std::array<GLuint, 8> none = {~0U, ~0U, ~0U, 0, 0, 0, 0, 0};
    bounds_ = gl::Buffer::of<GLuint>("bounds", none);
    const draw::Hierarchy::Solids solids{
        .count = static_cast<int>(balls ? places.size() : places.size() / 3),
        .places = &placeView_,
        .corners = &cornerView_,
        .words = &wordView_,
        .ballLooks = &ballLookView_,
        .materials = &lookView_};
    hierarchy_.growBounds(solids, bounds_);
    gl::barrier();
    hierarchy_.build(solids, bounds_);
    sorted = hierarchy_.sorted().readAll<glm::uvec4>();
    sorted.resize(static_cast<std::size_t>(solids.count) * (balls ? 2 : 3));
    twin.sorted = sorted;
    const auto keys = bounds_.readAll<GLuint>();
    for (int axis = 0; axis < 3; ++axis) {
      twin.low[axis] = fromKey(keys[static_cast<std::size_t>(axis)]);
      twin.high[axis] = fromKey(keys[static_cast<std::size_t>(axis) + 3]);
    }
    if (!(twin.low.x <= twin.high.x)) twin.low = twin.high = glm::vec3(0);
  }

  std::vector<RayTwin::Hit> traced(const std::vector<TracedRay>& rays, bool any = false) {
    std::vector<glm::vec4> texels;
    for (const TracedRay& ray : rays) {
      texels.emplace_back(ray.origin, 0);
      texels.emplace_back(ray.along, ray.far);
    }
    const gl::Buffer from = gl::Buffer::of<glm::vec4>("rays", texels);
    const gl::Texture view = gl::Texture::view("rays", GL_RGBA32F, from);
    const gl::Buffer hits("hits", 16 * rays.size());
    const int count = static_cast<int>(rays.size());
    const gl::Kernel<draw::TraceRays> kernel(gl::Defines(),
                                             {.triangles = !balls_, .balls = balls_, .anyHit = any});
    const gl::Resource sorted = hierarchy_.sortedTexels(), nodes = hierarchy_.nodeTexels();
    kernel.dispatch(draw::inRows(count), {.solids = {.solids = sorted, .ids = {}, .balls = sorted},
                                          .trees = {.solidNodes = nodes,
                                                    .ballNodes = nodes,
                                                    .solidCount = hierarchy_.count(),
                                                    .solidLeaves = hierarchy_.leaves(),
                                                    .ballCount = hierarchy_.count(),
                                                    .ballLeaves = hierarchy_.leaves()},
                                          .bounds = bounds_,
                                          .rays = view,
                                          .firstRay = 0,
                                          .rayCount = count,
                                          .hits = hits});
    gl::barrier();
    std::vector<RayTwin::Hit> found;
    for (const glm::uvec4& words : hits.readAll<glm::uvec4>())
      found.push_back({std::bit_cast<float>(words.x),
                       static_cast<int>(words.y),
                       {std::bit_cast<float>(words.z), std::bit_cast<float>(words.w)}});
    testContext().check();
    return found;
  }

  std::vector<glm::uvec4> sorted;
  RayTwin twin;

 private:
  static float fromKey(GLuint key) {
    return std::bit_cast<float>(key ^ ((key >> 31U) != 0 ? 0x80000000U : 0xffffffffU));
  }
  bool balls_;
  draw::Hierarchy hierarchy_;
  gl::Buffer places_, corners_, words_, ballLooks_, looks_, bounds_;
  gl::Texture placeView_, cornerView_, wordView_, ballLookView_, lookView_;
};

using Random = std::minstd_rand;
float between(Random& random, float low, float high) {
  const auto unit = static_cast<float>(random() % 1000003U) / 1000003.0F;
  return low + (high - low) * unit;
}
glm::vec3 placed(Random& random, float size) {
  return {between(random, -size, size), between(random, -size, size), between(random, -size, size)};
}

/// Returns triangles of all sizes. Of every eight, one is degenerate, one is in a plane with many others,
/// one duplicates another, and one is marked as invalid.
std::vector<glm::vec4> someTriangles(int count, Random& random) {
  std::vector<glm::vec4> places;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 middle = placed(random, 3);
    const float size = i % 31 == 0 ? 4.0F : between(random, 0.02F, 0.6F);
    std::array<glm::vec3, 3> corners = {middle + placed(random, size), middle + placed(random, size),
                                        middle + placed(random, size)};
    if (i % 8 == 1) corners[2] = 0.5F * (corners[0] + corners[1]);
    if (i % 16 == 9) corners[2] = corners[1];
    if (i % 8 == 3)
      for (glm::vec3& corner : corners) corner.y = 0.5F;
    for (int k = 0; k < 3; ++k) {
      const std::size_t twin = places.size();
      if (i % 8 == 5)
        places.push_back(places[twin - 3]);
      else
        places.emplace_back(corners.at(static_cast<std::size_t>(k)), i % 8 == 7 ? 0.0F : 1.0F);
    }
  }
  return places;
}

std::vector<TracedRay> someRays(const std::vector<glm::vec4>& places, std::size_t count, Random& random) {
  std::vector<TracedRay> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 origin = placed(random, i % 3 == 0 ? 6.0F : 2.0F);
    glm::vec3 along = placed(random, 1);
    if (i % 4 == 1)
      along = glm::vec3(places[random() % places.size()]) - origin;  // the ray goes through a
                                                                     // corner
    if (i % 8 == 2) along[static_cast<int>(i / 8 % 3)] = 0;          // the ray is perpendicular to an axis
    if (i % 16 == 6) along = glm::vec3(0, 0, i % 32 < 16 ? 1 : -1);
    if (!(glm::length(along) > 1e-6F)) along = glm::vec3(0, 1, 0);
    rays.push_back({origin, glm::normalize(along), i % 5 == 4 ? between(random, 0, 3) : 1e9F});
  }
  return rays;
}

}  // namespace

TEST_CASE("hierarchy: rays meet what a loop over all triangles finds, to the bit") {
  Random random(7);
  for (const int count : {1, 2, 3, 5, 63, 64, 65, 1237}) {
    CAPTURE(count);
    const std::vector<glm::vec4> places = someTriangles(count, random);
    HierarchyStage stage(places, false);
    const std::vector<TracedRay> rays = someRays(places, 1500, random);
    const auto hits = stage.traced(rays), open = stage.traced(rays, true);
    int met = 0, wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const RayTwin::Hit wanted = stage.twin.nearestTriangle(rays[i].origin, rays[i].along, rays[i].far);
      met += wanted.at >= 0 ? 1 : 0;
      wrong += wanted == hits[i] ? 0 : 1;
      wrong += (wanted.at >= 0) == (open[i].t == 0) ? 0 : 1;
    }
    CHECK(wrong == 0);
    if (count >= 63) CHECK(met > 60);
  }
}

TEST_CASE("hierarchy: rays meet what a loop over all balls finds, to the bit") {
  Random random(11);
  for (const int count : {1, 3, 257}) {
    CAPTURE(count);
    std::vector<glm::vec4> balls;
    for (int i = 0; i < count; ++i)
      balls.emplace_back(placed(random, 3), i % 9 == 4 ? 0.0F : between(random, 0.05F, 0.7F));
    HierarchyStage stage(balls, true);
    const std::vector<TracedRay> rays = someRays(balls, 1500, random);
    const auto hits = stage.traced(rays);
    int met = 0, wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const RayTwin::Hit wanted = stage.twin.nearestBall(rays[i].origin, rays[i].along, rays[i].far);
      met += wanted.at >= 0 ? 1 : 0;
      wrong += wanted == hits[i] ? 0 : 1;
    }
    CHECK(wrong == 0);
    CHECK(met > 10);
  }
}

TEST_CASE("hierarchy: what rays meet of triangles and balls, in float64") {
  Random random(5);
  std::vector<glm::vec4> places;
  for (int i = 0; i < 400; ++i) {
    const glm::vec3 middle = placed(random, 3);
    for (int k = 0; k < 3; ++k) places.emplace_back(middle + placed(random, 0.5F), 1.0F);
  }
  HierarchyStage stage(places, false);
  const std::vector<TracedRay> rays = someRays(places, 2000, random);
  const auto hits = stage.traced(rays);
  int compared = 0, wrong = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (i % 4 == 1) continue;  // Skips these rays, because a ray through a corner may hit or miss.
    const glm::dvec3 origin(rays[i].origin), along(rays[i].along);
    double nearest = static_cast<double>(rays[i].far), margin = 1;
    for (std::size_t k = 0; k < places.size(); k += 3) {
      const glm::dvec3 a(places[k]), b(places[k + 1]), c(places[k + 2]);
      const glm::dvec3 n = glm::cross(b - a, c - a);
      const double towards = glm::dot(n, along);
      const double t = glm::dot(a - origin, n) / towards;
      const glm::dvec3 p = origin + t * along;
      const double square = glm::dot(n, n);
      const double inside =
          std::min({glm::dot(glm::cross(b - a, p - a), n), glm::dot(glm::cross(c - b, p - b), n),
                    glm::dot(glm::cross(a - c, p - c), n)}) /
          square;
      if (t <= 0 || t > nearest + 1e-3) continue;
      if (std::abs(inside) < 1e-4 || std::abs(towards) < 1e-3 * std::sqrt(square)) margin = 0;
      if (inside >= 0) nearest = std::min(nearest, t);
    }
    if (margin == 0) continue;
    ++compared;
    if (std::abs(static_cast<double>(hits[i].t) - nearest) > 1e-4 * (1 + nearest)) ++wrong;
  }
  CHECK(compared > 1000);
  CHECK(wrong == 0);
}

TEST_CASE("hierarchy: no ray gets out of what is closed, not through edges or corners either") {
  constexpr int around = 24, rows = 13;
  std::vector<glm::vec3> corners;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < around; ++i) {
      const double turn = 2 * 3.14159265358979 * i / around, down = 3.14159265358979 * j / rows;
      corners.emplace_back(std::sin(down) * std::cos(turn), std::cos(down),
                           std::sin(down) * std::sin(turn));
    }
  std::vector<glm::vec4> places;
  const auto corner = [&](int i, int j) {
    places.emplace_back(
        corners[static_cast<std::size_t>(j == 0 || j == rows ? j * around : j * around + i % around)],
        1.0F);
  };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < around; ++i) {
      corner(i, j), corner(i + 1, j), corner(i, j + 1);
      corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1);
    }
  HierarchyStage stage(places, false);
  std::vector<TracedRay> rays;
  Random random(3);
  for (int n = 0; n < 3; ++n) {
    const glm::vec3 origin = n == 0 ? glm::vec3(0) : placed(random, 0.4F);
    for (std::size_t i = 0; i < places.size(); ++i) {
      rays.push_back({origin, glm::normalize(glm::vec3(places[i]) - origin)});
      const glm::vec3 other(places[i % 3 == 2 ? i - 2 : i + 1]);
      const float share = between(random, 0, 1);
      rays.push_back({origin, glm::normalize(glm::mix(glm::vec3(places[i]), other, share) - origin)});
    }
  }
  int escaped = 0;
  for (const RayTwin::Hit& hit : stage.traced(rays)) escaped += hit.at < 0 ? 1 : 0;
  CHECK(escaped == 0);
}

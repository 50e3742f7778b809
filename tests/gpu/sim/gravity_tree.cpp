#include "sim/particles/gravity_tree.hpp"

#include "base/error.hpp"
#include "gpu/context.hpp"
#include "reference/gravity_tree_twin.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

constexpr Cloud clouds[] = {Cloud::plummer,  Cloud::disk, Cloud::twoClusters,
                            Cloud::onePoint, Cloud::line, Cloud::farClusters};

struct Setup {
  float gravity = 1;
  float softening = 0.02F;
  float opening = 0.5F;
  bool fast = false;
};

std::vector<glm::vec4> onDevice(const std::vector<glm::vec4>& bodies, const Setup& setup = {}) {
  testContext();
  const int count = static_cast<int>(bodies.size());
  sim::GravityTree tree("stars", count, setup.fast);
  const gl::Vec4Array positions("positions", bodies);
  const gl::Vec4Array accelerations("accelerations", std::vector<glm::vec4>(bodies.size(), glm::vec4(7)));
  tree.accelerate(positions, accelerations, count, setup.gravity, setup.softening, setup.opening);
  return accelerations.buffer().readAll<glm::vec4>();
}

std::size_t differentWords(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
  REQUIRE(a.size() == b.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (int k = 0; k < 4; ++k)
      different += std::bit_cast<std::uint32_t>(a[i][k]) == std::bit_cast<std::uint32_t>(b[i][k]) ? 0 : 1;
  return different;
}

void compareWithTwin(const std::vector<glm::vec4>& bodies, const Setup& setup = {}) {
  GravityTreeTwin twin(bodies, setup.opening);
  CHECK(differentWords(onDevice(bodies, setup), twin.accelerations(setup.gravity, setup.softening)) == 0);
}

struct Errors {
  double median, max99;  ///< median and 99th percentile of the error relative to each body's exact
                         ///< acceleration
};

/// Returns the errors relative to a sum over all pairs in double precision. `relativeToMean`: true to
/// divide by the root mean square of all accelerations, false to divide by each body's acceleration. The
/// former is needed for bodies on a line, where the forces from both sides cancel in the middle.
Errors errorsOf(const std::vector<glm::vec4>& bodies, const std::vector<glm::vec4>& got, const Setup& setup,
                bool relativeToMean = false) {
  std::vector<int> of(bodies.size());
  std::iota(of.begin(), of.end(), 0);
  const auto exact = allPairs(bodies, of, setup.gravity, setup.softening);
  double squares = 0;
  for (const glm::dvec3& a : exact) squares += glm::dot(a, a) / static_cast<double>(exact.size());
  const auto errors = relativeErrors(got, exact, of, relativeToMean ? std::sqrt(squares) : 1e-30);
  return {errors[errors.size() / 2], errors[errors.size() * 99 / 100]};
}

}  // namespace

TEST_CASE("gravity tree equals its CPU twin bit for bit") {
  for (const Cloud cloud : clouds) {
    CAPTURE(static_cast<int>(cloud));
    compareWithTwin(bodiesOf(cloud, 1021));
    compareWithTwin(bodiesOf(cloud, 5003), {0.01F, 0.1F, 0.7F});
  }
  for (const int count : {1, 2, 7, 65}) compareWithTwin(bodiesOf(Cloud::plummer, count));
}

TEST_CASE("gravity tree equals its CPU twin with more bodies than one tree holds") {
  compareWithTwin(bodiesOf(Cloud::disk, 40009), {1, 0.05F, 0.8F});
}

TEST_CASE("gravity tree errors against all pairs are small") {
  const Setup setup;
  for (const Cloud cloud : clouds)
    for (const int count : {1021, 5003}) {
      const auto bodies = bodiesOf(cloud, count);
      const Errors errors = errorsOf(bodies, onDevice(bodies), setup, cloud == Cloud::line);
      CAPTURE(static_cast<int>(cloud));
      CAPTURE(count);
      MESSAGE("median ", errors.median, ", 99th percentile ", errors.max99);
      CHECK(errors.median < 0.0005);
      CHECK(errors.max99 < 0.003);
    }
}

TEST_CASE("gravity tree errors with fast numerics are as small") {
  Setup setup;
  setup.fast = true;
  const auto bodies = bodiesOf(Cloud::twoClusters, 5003);
  const Errors errors = errorsOf(bodies, onDevice(bodies, setup), setup);
  CHECK(errors.median < 0.0005);
  CHECK(errors.max99 < 0.003);
}

TEST_CASE("gravity tree errors vanish as the opening angle goes to 0") {
  const auto bodies = bodiesOf(Cloud::plummer, 1021);
  Setup setup;
  double last = 1;
  for (const float opening : {1.0F, 0.5F, 0.25F, 0.0F}) {
    setup.opening = opening;
    const Errors errors = errorsOf(bodies, onDevice(bodies, setup), setup);
    // 1e-6 is about the rounding error of single precision.
    CHECK(errors.median < std::max(0.7 * last, 1e-6));
    last = errors.median;
  }
  CHECK(last < 1e-6);
}

TEST_CASE("gravity tree with opening angle 0 includes every body, also with limited shader loops") {
  // The number of bodies exceeds the 32768 bodies and 8191 nodes that one dispatch can visit.
  const auto bodies = bodiesOf(Cloud::plummer, 33001);
  const auto got = onDevice(bodies, {1, 0.02F, 0});
  std::vector<int> of;
  for (int i = 5; i < 33001; i += 1031) of.push_back(i);
  const auto errors = relativeErrors(got, allPairs(bodies, of, 1, 0.02F), of);
  CHECK(errors.back() < 1e-4);
}

TEST_CASE("gravity tree gives the same bits on every run") {
  const auto bodies = bodiesOf(Cloud::farClusters, 5003);
  const auto first = onDevice(bodies);
  for (int run = 0; run < 3; ++run) CHECK(differentWords(first, onDevice(bodies)) == 0);
}

TEST_CASE("the gravity tree's root holds the total mass and the centre of mass") {
  testContext();
  const auto bodies = bodiesOf(Cloud::twoClusters, 5003);
  sim::GravityTree tree("stars", 6000, false);
  const gl::Vec4Array positions("positions", bodies);
  tree.sort(positions, 5003);
  tree.build(positions, 5003, 0.5F);
  const auto moments = tree.moments().buffer().readAll<glm::vec4>();
  const auto cells = tree.cells().buffer().readAll<glm::vec4>();
  double mass = 0;
  glm::dvec3 center(0);
  for (const glm::vec4& body : bodies) {
    mass += body.w;
    center += glm::dvec3(body) * static_cast<double>(body.w);
  }
  center /= mass;
  glm::dmat3 spread(0);
  for (const glm::vec4& body : bodies) {
    const glm::dvec3 s = glm::dvec3(body) - center;
    spread += glm::outerProduct(s, s) * (3 * body.w / mass);
  }
  CHECK(moments[2].x == doctest::Approx(mass).epsilon(1e-6));
  for (int k = 0; k < 3; ++k) CHECK(cells[1][k] == doctest::Approx(center[k]).epsilon(1e-5));
  CHECK(moments[2].y == doctest::Approx(spread[0][0]).epsilon(1e-5));
  CHECK(moments[2].z == doctest::Approx(spread[0][1]).epsilon(1e-5));
  CHECK(moments[2].w == doctest::Approx(spread[0][2]).epsilon(1e-5));
  CHECK(moments[3].x == doctest::Approx(spread[1][1]).epsilon(1e-5));
  CHECK(moments[3].y == doctest::Approx(spread[1][2]).epsilon(1e-5));
  CHECK(moments[3].z == doctest::Approx(spread[2][2]).epsilon(1e-5));
}

TEST_CASE("gravity tree forces move the centre of mass only slightly") {
  // Approximating bodies by nodes violates Newton's third law for pairs, so a net force remains. It must be
  // small compared with the sum of the magnitudes of all forces.
  for (const Cloud cloud : {Cloud::plummer, Cloud::disk, Cloud::twoClusters}) {
    const auto bodies = bodiesOf(cloud, 5003);
    const auto accelerations = onDevice(bodies);
    glm::dvec3 net(0);
    double pulls = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const glm::dvec3 force = glm::dvec3(accelerations[i]) * static_cast<double>(bodies[i].w);
      net += force;
      pulls += glm::length(force);
    }
    CHECK(glm::length(net) < 1e-4 * pulls);
  }
}

TEST_CASE("two bodies pull each other by Newton's law") {
  const std::vector<glm::vec4> bodies = {{1, 2, 3, 5}, {4, 6, 3, 2}};
  const auto a = onDevice(bodies, {2, 0, 0.5F});
  CHECK(a[0].x == doctest::Approx(2 * 2 / 25.0 * 0.6).epsilon(1e-6));
  CHECK(a[0].y == doctest::Approx(2 * 2 / 25.0 * 0.8).epsilon(1e-6));
  CHECK(a[1].y == doctest::Approx(-2 * 5 / 25.0 * 0.8).epsilon(1e-6));
  CHECK(a[0].z == 0.0F);
}

TEST_CASE("bodies without mass or with a NaN position exert no gravity") {
  auto bodies = bodiesOf(Cloud::disk, 1021);
  const auto without = onDevice(bodies);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<glm::vec4> idle = {{nan, 0, 0, 1}, {0, infinity, 0, 1}, {0, 0, -infinity, 1},
                                       {0, 0, 0, nan}, {0, 0, 0, 0},        {1e6F, 2, 3, 0},
                                       {0, 0, 0, -1},  {1e20F, 0, 0, 1}};
  bodies.insert(bodies.end(), idle.begin(), idle.end());
  auto with = onDevice(bodies);
  for (std::size_t i = 1021; i < bodies.size(); ++i) CHECK(with[i] == glm::vec4(0));
  with.resize(1021);
  CHECK(differentWords(with, without) == 0);
  compareWithTwin(bodies);
}

TEST_CASE("gravity tree walks end if all positions are NaN") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto got = onDevice(std::vector<glm::vec4>(1021, glm::vec4(nan)));
  for (const glm::vec4& a : got) CHECK(a == glm::vec4(0));
}

TEST_CASE("gravity tree visits few nodes for many bodies at one point") {
  GravityTreeTwin twin(bodiesOf(Cloud::onePoint, 40009), 0.5F);
  for (const glm::vec4& a : twin.accelerations(1, 0)) CHECK(a == glm::vec4(0));
  CHECK(twin.work.visits < 2 * 40009);
}

TEST_CASE("gravity tree with too many bodies reports the limit") {
  testContext();
  CHECK_THROWS_WITH_AS(sim::GravityTree("stars", 2000000000, false),
                       doctest::Contains("GL_MAX_SHADER_STORAGE_BLOCK_SIZE"), UserError);
}

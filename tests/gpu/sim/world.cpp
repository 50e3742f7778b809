#include "sim/world/world.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "gpu/context.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/core/state_hash.hpp"
#include "sim/world/list.hpp"

#include <doctest/doctest.h>

using namespace simreel;

namespace {

scene::Scene sheet(const char* cloth) {
  return scene::parseScene(
      fmt::format(R"({{"version": 1, "time": {{"start": 0.1}}, "objects": {{"a": {{"cloth": {}}}}}}})",
                  cloth),
      "test.json", {}, sim::kinds());
}

std::string hashAt(const scene::Scene& scene, int frame) {
  sim::World world(scene);
  world.advanceTo(frame);
  world.startSummary();
  const auto summary = world.takeSummary(true);
  REQUIRE(summary.has_value());
  CHECK(summary->frame == frame);
  return summary->stateHash;
}

}  // namespace

TEST_CASE("the state hash differs between frames and seeds and is repeatable") {
  testContext();
  const auto scene = sheet(R"({"size": [33, 21], "jitter": 0.01})");
  const auto first = hashAt(scene, 5);
  CHECK(first.size() == 32);
  CHECK(hashAt(scene, 5) == first);
  CHECK(hashAt(scene, 6) != first);
  CHECK(hashAt(sheet(R"({"size": [33, 21], "jitter": 0.011})"), 5) != first);
}

TEST_CASE("the state hash is the same on every device") {
  testContext();
  // The hash is fixed, so that any change of the cloth's arithmetic is noticed. llvmpipe and an NVIDIA H200
  // give the same hash.
  CHECK(hashAt(sheet(R"({"size": [33, 21], "jitter": 0.01})"), 60) == "871a618e330b5bbfb27a0535a89326d8");
}

TEST_CASE("the state hash covers every word of small and large arrays") {
  testContext();
  const sim::StateHash kernel;
  // The numbers are odd, and the last one exceeds the number of invocations of one dispatch.
  for (const unsigned count : {1U, 63U, 257U, 300007U}) {
    CAPTURE(count);
    std::vector<glm::uvec4> words;
    glm::uvec4 expected(3, 0, 0, 9);
    for (unsigned i = 0; i < count; ++i) {
      words.emplace_back(shader::hash3({i, 3, 5}), i * 7);
      const glm::uvec4 w = words.back();
      const auto a = shader::hash3({w.x ^ i, w.y, w.z ^ (5 * 0x9e3779b9U)});
      const auto b = shader::hash3({w.w + a.x, a.y, a.z ^ i});
      expected += glm::uvec4(a.x ^ b.y, b);
    }
    const gl::Buffer sums =
        gl::Buffer::of<glm::uvec4>("sums", std::vector<glm::uvec4>{glm::uvec4(1), {3, 0, 0, 9}});
    kernel.add(gl::Buffer::of<glm::uvec4>("words", words), 4, sums, 1);
    gl::barrier();
    const auto found = sums.readAll<glm::uvec4>();
    CHECK(found[0] == glm::uvec4(1));
    CHECK(found[1] == expected);
  }
}

TEST_CASE("the state hash of plane-stored arrays equals the hash of their elements") {
  testContext();
  const sim::StateHash kernel;
  for (const int planes : {1, 3, 4})
    for (const unsigned count : {1U, 257U, 300007U}) {
      CAPTURE(planes);
      CAPTURE(count);
      std::vector<glm::uvec4> elements(count, glm::uvec4(0));
      const std::size_t before = gl::BufferPart::alignment / 4;
      std::vector<std::uint32_t> words(before, 9U);
      for (int plane = 0; plane < planes; ++plane)
        for (unsigned i = 0; i < count; ++i) {
          words.push_back(shader::hash3({i, static_cast<unsigned>(plane), 5}).x);
          elements[i][plane] = words.back();
        }
      const auto buffer = gl::Buffer::of<std::uint32_t>("planes", words);
      const sim::StateArray array{
          "planes", &buffer, true, {{&buffer, 4 * before, 4 * (words.size() - before)}, planes, count}};
      CHECK(array.elements() == count);
      CHECK(array.readAll<glm::uvec4>() == elements);
      const gl::Buffer sums = gl::Buffer::of<glm::uvec4>("sums", std::vector<glm::uvec4>(2, glm::uvec4(0)));
      kernel.add(array, 4, sums, 1);
      gl::barrier();
      kernel.add(gl::Buffer::of<glm::uvec4>("elements", elements), 4, sums, 0);
      gl::barrier();
      const auto found = sums.readAll<glm::uvec4>();
      CHECK(found[0] == found[1]);
      CHECK(found[0] != glm::uvec4(0));
    }
}

TEST_CASE("a diverging simulation is reported in its frame, with step, particle and advice") {
  testContext();
  const auto scene =
      sheet(R"({"size": [9, 7], "stiffness": 1e7, "mass": 0.001, "substeps": 2, "jitter": 0.01})");
  sim::World world(scene);
  std::string message;
  int frame = 0;
  for (; frame < 60 && message.empty(); ++frame) {
    world.advanceTo(frame);
    world.startSummary();
    try {
      static_cast<void>(world.takeSummary(true));
    } catch (const UserError& error) {
      CHECK(error.code() == ExitCode::device);
      message = error.what();
    }
  }
  CHECK(message.find("cloth \"a\" blew up in substep") != std::string::npos);
  CHECK(message.find("particle (") != std::string::npos);
  CHECK(message.find("more substeps") != std::string::npos);
}

// Tests step traces of real runs: the hash sums, and the exact location of a change in the state.
#include "golden/trace/trace.hpp"

#include "base/error.hpp"
#include "golden/trace/file.hpp"
#include "golden/trace/layout.hpp"
#include "golden/trace/stream.hpp"
#include "gpu/context.hpp"
#include "scene/load.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/world/list.hpp"

#include <cstdint>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::golden;

namespace {

/// Returns two cloths of odd sizes with different numbers of steps per frame and three frames of pre-roll.
scene::Scene odd(const std::vector<scene::Override>& changes = {}) {
  return scene::parseScene(R"({"version": 1, "time": {"fps": 30, "start": 0.1, "duration": 1}, "objects": {
        "ball": {"sphere": {"position": [0, -1, 0]}},
        "a": {"cloth": {"size": [33, 21], "jitter": 0.01, "substeps": 5}},
        "b": {"cloth": {"size": [7, 5], "position": [3, 1, 0], "substeps": 2}}}})",
                           "test.json", changes, sim::kinds());
}

constexpr std::size_t ample = 1 << 20;

/// Flips the lowest bit of one word of a state array.
void disturb(const sim::World& world, std::size_t object, std::size_t array, long element, int component) {
  const gl::Buffer& buffer = *world.object(object).state()[array].buffer;
  const auto offset = static_cast<GLintptr>(element * 16 + component * 4);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::uint32_t word = 0;
  glGetNamedBufferSubData(buffer.name(), offset, 4, &word);
  word ^= 1U;
  glNamedBufferSubData(buffer.name(), offset, 4, &word);
}

/// CPU version of the element hash in glsl/common/block_hash.comp.
std::uint32_t elementHash(const std::uint32_t* w, std::uint32_t i) {
  const auto a = shader::hash3(glm::uvec3(w[0] ^ i, w[1], w[2]));
  return shader::hash3(glm::uvec3(w[3] + a.x, a.y, a.z ^ i)).x;
}

}  // namespace

TEST_CASE("trace: GPU hash sums equal the CPU's for every block size") {
  testContext();
  const auto scene = odd();
  sim::World world(scene);
  world.advanceTo(2);
  std::vector<std::vector<std::uint32_t>> state;
  for (const std::size_t object : {1U, 2U})
    for (const auto& array : world.object(object).state())
      state.push_back(array.buffer->readAll<std::uint32_t>());
  for (const std::size_t max : {ample, std::size_t{6000}, std::size_t{1200}, std::size_t{10}}) {
    const auto trace = traceRun(scene, 2, max);
    REQUIRE(trace.firstFrame == -3);
    REQUIRE(trace.frames == 5);
    REQUIRE(trace.arrays.size() == 4);
    CHECK(trace.arrays[0].steps == 5);
    CHECK(trace.arrays[2].steps == 2);
    const bool every = trace.detailed == 5;
    std::size_t at = trace.totalWords() - trace.frameWords(5);
    for (std::size_t a = 0; a < 4; ++a) {
      const StepTrace::Array& array = trace.arrays[a];
      if (every) at += std::size_t{array.words()} * (array.steps - 1);
      std::vector<std::uint32_t> expected(array.words());
      for (std::uint32_t i = 0; i < array.elements; ++i) {
        const std::uint32_t h = elementHash(&state[a][i * 4], i);
        expected[i / array.perBlock] += h;
        expected.back() += (i + 1) * h;
      }
      INFO(max, " ", array.name, " in blocks of ", array.perBlock);
      CHECK(std::vector(&trace.words[at], &trace.words[at] + array.words()) == expected);
      at += array.words();
    }
    CHECK(at == trace.words.size());
  }
}

// On the storage-buffer memory path, the arrays of a fluid are stored as planes.
TEST_CASE("trace: the hash sums of a fluid equal those of its elements") {
  testContext();
  const auto scene = scene::parseScene(R"({"version": 1, "objects": {"bath": {"fluid": {"size": [37, 22],
      "speed": 75, "substeps": 1, "strokes": [{"until": 9, "radius": 3, "from": [9, 9, 0], "velocity": [60, 9, 0],
      "dye": [1, 0.5, 0.2]}]}}}})",
                                       "test.json", {}, sim::kinds());
  sim::World world(scene);
  world.advanceTo(1);
  for (const std::size_t max : {ample, std::size_t{300}}) {
    const auto trace = traceRun(scene, 1, max);
    REQUIRE(trace.arrays.size() == 2);
    std::size_t at = trace.frameWords(0);
    for (std::size_t a = 0; a < 2; ++a) {
      const StepTrace::Array& array = trace.arrays[a];
      const auto words = world.object(0).state()[a].readAll<std::uint32_t>();
      REQUIRE(words.size() == std::size_t{4} * array.elements);
      std::vector<std::uint32_t> expected(array.words());
      for (std::uint32_t i = 0; i < array.elements; ++i) {
        const std::uint32_t h = elementHash(&words[i * 4], i);
        expected[i / array.perBlock] += h;
        expected.back() += (i + 1) * h;
      }
      INFO(max, " ", array.name, " in blocks of ", array.perBlock);
      CHECK(std::vector(&trace.words[at], &trace.words[at] + array.words()) == expected);
      at += array.words();
    }
  }
}

TEST_CASE("trace: repeating a run matches its own trace, also through a file and at any resolution") {
  testContext();
  const auto scene = odd();
  const auto fine = traceRun(scene, 4, ample);
  for (const std::size_t max : {ample, std::size_t{1500}, std::size_t{100}}) {
    const auto trace = decodeTrace(encodeTrace(traceRun(scene, 4, max)), "steps.bin");
    CHECK(!firstDivergence(scene, trace));
    CHECK(!compareTraces(fine, trace));
  }
}

TEST_CASE("trace: a changed word is located by frame, step, array and element") {
  testContext();
  const auto scene = odd();
  const auto baseline = traceRun(scene, 4, ample);
  struct Place {
    int frame;
    std::size_t object, array;
    int step;
    long element;
  };
  const Place places[] = {{-2, 1, 0, 1, 0}, {-1, 1, 1, 5, 692}, {0, 1, 0, 3, 341},
                          {1, 2, 1, 2, 34}, {4, 2, 0, 1, 17},   {4, 1, 1, 5, 33}};
  for (const Place& p : places) {
    const auto run = traceRun(scene, 4, ample, [&](const sim::World& world, std::size_t object, int step) {
      if (world.frame() + 1 == p.frame && object == p.object && step == p.step)
        disturb(world, object, p.array, p.element, 1);
    });
    const auto found = compareTraces(run, baseline);
    REQUIRE(found.has_value());
    INFO(found->message);
    CHECK(found->frame == p.frame);
    CHECK(found->step == p.step);
    CHECK(found->steps == (p.object == 1 ? 5 : 2));
    CHECK(found->object == (p.object == 1 ? "a" : "b"));
    CHECK(found->buffer == (p.array == 0 ? "positions" : "velocities"));
    CHECK(found->firstElement == p.element);
    CHECK(found->lastElement == p.element);
  }
}

TEST_CASE("trace: firstDivergence names the particle, or only the frame if steps are not stored") {
  testContext();
  const auto scene = odd();
  const auto disturbed = [&](std::size_t max) {
    return traceRun(scene, 4, max, [](const sim::World& world, std::size_t object, int step) {
      if (world.frame() + 1 == 2 && object == 1 && step == 5) disturb(world, object, 0, 12 + 33 * 20, 0);
    });
  };
  const auto found = firstDivergence(scene, disturbed(ample));
  REQUIRE(found.has_value());
  CHECK(found->message == "leaves the baseline at frame 2, step 5 of 5: a.positions, particle (12, 20)");
  const auto late = firstDivergence(scene, disturbed(100));
  REQUIRE(late.has_value());
  CHECK(late->frame == 2);
  CHECK(late->step == 0);
  CHECK(late->message.find("simreel bisect") != std::string::npos);
}

TEST_CASE("trace: a changed scene diverges from the baseline at the expected step") {
  testContext();
  const auto baseline = traceRun(odd(), 3, ample);
  const auto seed = firstDivergence(odd({{"objects.a.cloth.jitter", "0.011"}}), baseline);
  REQUIRE(seed.has_value());
  CHECK(seed->frame == -3);
  CHECK(seed->message.find("in its first state: a.positions") != std::string::npos);
  const auto damped = firstDivergence(odd({{"objects.a.cloth.damping", "4.9"}}), baseline);
  REQUIRE(damped.has_value());
  CHECK(damped->frame == -2);
  CHECK(damped->step == 1);
  const auto bigger = firstDivergence(odd({{"objects.a.cloth.size", "[33,23]"}}), baseline);
  REQUIRE(bigger.has_value());
  CHECK(bigger->frame == -3);
  CHECK(bigger->message.find("759 elements") != std::string::npos);
}

TEST_CASE("trace: a NaN state is traced") {
  testContext();
  const auto scene = odd({{"objects.a.cloth.stiffness", "1e7"}, {"objects.a.cloth.mass", "0.001"}});
  for (const std::size_t max : {ample, std::size_t{100}}) {
    try {
      static_cast<void>(traceRun(scene, 29, max));
      FAIL("nothing was thrown");
    } catch (const UserError& error) {
      CHECK(error.code() == ExitCode::device);
      CHECK(std::string(error.what()).find("cloth \"a\" blew up") != std::string::npos);
    }
  }
}

TEST_CASE("trace: traces of frames, traces of steps and dumps agree") {
  testContext();
  const auto scene = odd();
  std::vector<StateLine> frames;
  std::vector<StateLine> steps;
  const auto into = [](std::vector<StateLine>& lines) {
    return [&lines](const std::string& line) {
      lines.push_back(readStateLine(line));
      return true;
    };
  };
  sim::World first(scene);
  traceFrames(first, -3, 3, into(frames));
  REQUIRE(frames.size() == 7);
  sim::World second(scene);
  traceSteps(second, 2, into(steps));
  REQUIRE(steps.size() == 7);  // Object a makes five steps, and object b two.
  const StateLine& frame = frames[5];
  CHECK(frame.frame == 2);
  REQUIRE(frame.arrays.size() == 4);
  CHECK(steps[4].step == 5);
  CHECK(steps[4].object == "a");
  CHECK(steps[4].arrays == decltype(frame.arrays)(frame.arrays.begin(), frame.arrays.begin() + 2));
  CHECK(steps[6].arrays == decltype(frame.arrays)(frame.arrays.begin() + 2, frame.arrays.end()));
  CHECK(steps[3].arrays != steps[4].arrays);

  sim::World third(scene);
  const auto dump = dumpState(third, 2, 5);
  sim::World fourth(scene);
  fourth.advanceTo(2);
  REQUIRE(dump.arrays.size() == 4);
  std::size_t next = 0;
  for (const std::size_t object : {1U, 2U})
    for (const auto& array : fourth.object(object).state())
      CHECK(dump.arrays[next++].words == array.buffer->readAll<std::uint32_t>());
}

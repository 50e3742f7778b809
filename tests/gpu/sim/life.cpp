#include "sim/life/life.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "gpu/context.hpp"
#include "reference/life_twin.hpp"
#include "sim/life/stepper.hpp"
#include "source_folder.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cstring>
#include <random>
#include <utility>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::sim;

namespace {

LifeParameters grid(int width, int height) {
  LifeParameters p;
  p.size = {width, height};
  p.stepsPerSecond = 30;
  return p;
}

std::unique_ptr<Simulation> lifeOf(const LifeParameters& p, int seed, double frameSeconds) {
  scene::Object object;
  object.name = "cells";
  object.kind = "life";
  object.parameters = std::make_unique<LifeParameters>(p);
  static const std::vector<ColliderShape> colliders;
  return lifeKind().make(object, {false, seed, frameSeconds, &colliders});
}

/// Steps the GPU grid and its CPU twin and compares every word of the state.
void compare(const LifeParameters& p, int frames, double frameSeconds = 0.1, double start = 0) {
  testContext();
  const auto gpu = lifeOf(p, 7, frameSeconds);
  LifeTwin twin(LifePlan(p, "cells", 7, frameSeconds));
  const auto same = [&] {
    const auto state = gpu->state();
    REQUIRE(state[0].buffer->readAll<std::uint32_t>() == twin.words);
    REQUIRE(state.size() == (twin.trail.empty() ? 1 : 2));
    if (!twin.trail.empty()) REQUIRE(state[1].buffer->readAll<std::uint32_t>() == twin.trail);
  };
  same();
  for (int frame = 0; frame < frames; ++frame) {
    gpu->step(start + frame * frameSeconds, {});
    twin.step(start + frame * frameSeconds);
    if (frame % 5 == 0) same();
  }
  same();
}

}  // namespace

TEST_CASE("life equals its CPU twin at odd sizes, both borders") {
  for (const glm::ivec2 size :
       {glm::ivec2(33, 7), {257, 130}, {31, 5}, {1, 1}, {2, 3}, {127, 3}, {129, 66}}) {
    auto p = grid(size.x, size.y);
    compare(p, 12);
    p.border = LifeBorder::dead;
    compare(p, 12);
  }
}

TEST_CASE("life equals its CPU twin with several generations per pass") {
  for (const glm::ivec2 size : {glm::ivec2(128, 61), {256, 4}, {384, 35}, {512, 200}}) {
    for (const char* rule : {"B3/S23", "B03/S1238"}) {
      auto p = grid(size.x, size.y);
      p.rule = rule;
      p.stepsPerSecond = 113;  // The number of generations per frame is not a multiple of the number per
                               // pass.
      compare(p, 6);
      p.border = LifeBorder::dead;
      compare(p, 6);
    }
  }
}

TEST_CASE("life: every way to split the grid into workgroups gives the same cells") {
  testContext();
  std::mt19937 random(3);
  for (const glm::ivec2 size : {glm::ivec2(512, 77), {257, 33}, {384, 40}}) {
    for (const bool torus : {true, false}) {
      LifeRule rule{static_cast<int>(random() % 512), static_cast<int>(random() % 512)};
      auto p = grid(size.x, size.y);
      p.rule = rule.text();
      p.border = torus ? LifeBorder::torus : LifeBorder::dead;
      LifeTwin twin(LifePlan(p, "cells", 2, 0.1));
      std::vector<glm::uvec4> items(twin.words.size() / 4);
      std::memcpy(items.data(), twin.words.data(), twin.words.size() * 4);
      const gl::WordsArray start("cells", items);
      for (int i = 0; i < 8; ++i) twin.generation();
      for (const LifeTuning& tuning :
           {LifeTuning{1, 1, 16, {32, 2}}, LifeTuning{2, 1, 9, {8, 8}}, LifeTuning{4, 1, 32, {16, 4}},
            LifeTuning{1, 2, 64, {32, 1}}, LifeTuning{2, 2, 7, {4, 4}}, LifeTuning{8, 1, 5, {8, 4}},
            LifeTuning{4, 1, 16, {8, 1}, true}, LifeTuning{8, 2, 9, {8, 1}, true},
            LifeTuning{1, 1, 16, {8, 1}, true}}) {
        LifeStepper stepper(rule, torus, size, tuning);
        gl::WordsArray a("a", items);
        gl::WordsArray b("b", items);
        for (int done = 0; done < 8; done += stepper.maxSteps()) {
          gl::barrier();
          stepper.run(a, b, stepper.maxSteps());
          std::swap(a, b);
        }
        gl::barrier();
        CHECK_MESSAGE(a.buffer().readAll<std::uint32_t>() == twin.words, tuning.steps, " steps, ",
                      tuning.blocks, " blocks, ", tuning.rows, " rows");
      }
    }
  }
}

// Small grids are processed in tiles, and only tiles near changes are computed.
TEST_CASE("life equals its CPU twin with many generations per frame") {
  for (const glm::ivec2 size : {glm::ivec2(32, 32), {64, 33}, {96, 63}, {160, 77}, {512, 96}}) {
    for (const char* rule : {"B3/S23", "B03/S1238", "B2/S", "B36/S125"}) {
      CAPTURE(rule);
      auto p = grid(size.x, size.y);
      p.rule = rule;
      p.stepsPerSecond = 3013;
      compare(p, 3);
      p.border = LifeBorder::dead;
      compare(p, 3);
    }
  }
}

TEST_CASE("life equals its CPU twin after more generations than the loop limit of a dispatch") {
  for (const glm::ivec2 size : {glm::ivec2(32, 32), {256, 64}}) {
    auto p = grid(size.x, size.y);
    p.rule = "B2/S";  // With this rule, the grid never settles.
    p.stepsPerSecond = 20000;
    compare(p, 1, 1);
  }
}

TEST_CASE("life equals its CPU twin with a front that enters still regions at one cell per generation") {
  testContext();
  const simreel::test::TemporaryFile cell("cell.rle", "x = 1, y = 1\no!");
  // At the end of a pass, the distance from the front to the next tile equals the distance that the front
  // moves in the next pass. This is tested once on either side.
  for (const int at : {256, 263}) {
    auto p = grid(576, 448);
    p.rule = "B12345678/S012345678";
    p.fill = 0;
    p.patterns.resize(1);
    p.patterns[0].file = cell.path();
    p.patterns[0].at = glm::ivec2(at, at - 128);
    p.stepsPerSecond = 2560;
    compare(p, 1);
  }
}

TEST_CASE("life equals its CPU twin with gliders that cross still regions") {
  testContext();
  const simreel::test::TemporaryFile file(
      "gliders.rle",
      "x = 60, y = "
      "40\nbo20b3o10b2o$2bo19bobo10b2o$3o$10b2o8bo20b3o$10b2o30bo$18b3o19bobo20$50b3o$52bo$51bo!");
  auto p = grid(224, 150);
  p.fill = 0;
  p.patterns.resize(1);
  p.patterns[0].file = file.path();
  p.stepsPerSecond = 2571;
  compare(p, 6);
  p.border = LifeBorder::dead;
  compare(p, 6);
}

TEST_CASE("life equals its CPU twin for random rules") {
  std::mt19937 random(11);
  for (int trial = 0; trial < 10; ++trial) {
    auto p = grid(131, 67);
    p.rule = LifeRule{static_cast<int>(random() % 512), static_cast<int>(random() % 512)}.text();
    p.fill = 0.05F + 0.1F * static_cast<float>(trial);
    p.border = trial % 2 == 0 ? LifeBorder::torus : LifeBorder::dead;
    CAPTURE(p.rule);
    compare(p, 3);
  }
}

TEST_CASE("life with strokes and a trail equals its CPU twin") {
  auto p = grid(173, 91);
  p.trail = 7;
  StrokeParameters moving;
  moving.from = {-5, 30, 0};
  moving.to = {190, 60, 0};
  moving.until = 1.2;
  moving.radius = 9;
  moving.fraction = 0.4F;
  StrokeParameters eraser;
  eraser.shape = StrokeParameters::Shape::line;
  eraser.from = {20, 85, 0};
  eraser.to = {150, 3, 0};
  eraser.at = 0.5;
  eraser.radius = 4;
  eraser.value = 0;
  StrokeParameters stamp;
  stamp.shape = StrokeParameters::Shape::image;
  stamp.image = sourceFolder() + "/assets/textures/gingham.png";
  stamp.from = {-40, 11, 0};
  stamp.at = 1;
  p.strokes = {moving, eraser, stamp};
  compare(p, 20);
  p.trail = maxTrail;
  p.size = {16, 33};
  compare(p, 20);
  p.trail = 0;
  p.size = {256, 90};  // The kernel computes several generations per pass, except between strokes.
  p.stepsPerSecond = 170;
  compare(p, 15);
}

TEST_CASE("life starts before frame 0 if the scene does") {
  auto p = grid(67, 41);
  p.stepsPerSecond = 7;
  compare(p, 30, 0.1, -1.5);
}

TEST_CASE("life steps at its own rate, and a step callback also sees idle steps") {
  testContext();
  auto p = grid(64, 64);
  p.stepsPerSecond = 25;
  const auto life = lifeOf(p, 1, 1.0 / 10);
  CHECK(life->stepsPerFrame() == 3);
  std::vector<int> generations;
  for (int frame = 0; frame < 4; ++frame) {
    int calls = 0;
    life->step(frame * 0.1, [&](int step) { CHECK(step == ++calls); });
    CHECK(calls == 3);
    generations.push_back(static_cast<int>(life->measure()[2]));
  }
  CHECK(generations == std::vector<int>{2, 5, 7, 10});
}

TEST_CASE("life ends in the same state with and without a step callback, and its quantities count cells") {
  testContext();
  auto p = grid(256, 128);
  p.stepsPerSecond = 90;
  const auto a = lifeOf(p, 1, 0.1);
  const auto b = lifeOf(p, 1, 0.1);
  for (int frame = 0; frame < 3; ++frame) {
    a->step(frame * 0.1, {});
    b->step(frame * 0.1, [](int) {});
  }
  const auto words = a->state()[0].buffer->readAll<std::uint32_t>();
  CHECK(words == b->state()[0].buffer->readAll<std::uint32_t>());
  const auto cells = bytesOf(words, p.size);
  const auto alive = std::count(cells.begin(), cells.end(), 1);
  CHECK(a->measure()[0] == static_cast<double>(alive));
  CHECK(a->measure()[1] == static_cast<double>(alive) / (256 * 128));
  CHECK(a->measure()[2] == 27);
  CHECK(alive > 1000);
}

TEST_CASE("life publishes its cells, or its trail if it has one") {
  testContext();
  auto p = grid(130, 20);
  p.trail = 10;
  const auto life = lifeOf(p, 1, 0.1);
  Drawables drawables;
  life->publish(0, drawables);
  p.trail = 0;
  const auto plain = lifeOf(p, 1, 0.1);
  plain->publish(0, drawables);
  REQUIRE(drawables.fields.size() == 2);
  const Field& trail = drawables.fields[0];
  const Field& bits = drawables.fields[1];
  CHECK(*trail.name == "cells");
  CHECK(trail.cells == Field::Cells::bytes);
  CHECK(trail.size == glm::ivec2(130, 20));
  CHECK(trail.rowWords == 36);
  CHECK(bits.cells == Field::Cells::bits);
  CHECK(bits.rowWords == 8);
  CHECK(bits.words != nullptr);
  CHECK(life->elementName(3) == "cells (128 to 129, 1)");
}

TEST_CASE("life beyond the device's memory is refused with the name of the limit") {
  testContext();
  auto p = grid(maxLifeSide, maxLifeSide);
  try {
    static_cast<void>(lifeOf(p, 1, 0.1));
    FAIL("no error");
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::device);
    const std::string text = error.what();
    CHECK(text.find("1048576 x 1048576 cells needs 137438953472 bytes") != std::string::npos);
    CHECK(text.find("GL_MAX_SHADER_STORAGE_BLOCK_SIZE") != std::string::npos);
  }
}

// Tests the quantities and checks of simulations against known answers.
#include "golden/suite/check.hpp"

#include "base/error.hpp"
#include "gpu/context.hpp"
#include "measured.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

scene::Scene sceneOf(const std::string& objects, const std::string& checks) {
  return scene::parseScene(
      fmt::format(R"({{"version": 1, "objects": {{{}}}, "checks": [{}]}})", objects, checks), "test.json",
      {}, sim::kinds());
}

/// Returns a scene with a sheet of 12x8 particles of 0.25 kg that falls freely from a height of 10 m.
scene::Scene falling(const std::string& checks) {
  return sceneOf(R"("sheet": {"cloth": {"size": [12, 8], "mass": 0.25, "position": [0, 10, 0], "damping": 0,
                    "wind": [0, 0, 0], "substeps": 4, "pins": []}}, "ball": {"sphere": {"collides": false}})",
                 checks);
}

double quantity(const sim::World& world, const scene::Scene& scene, const std::string& name) {
  return named(*scene.objects.at(0).parameters, world.object(0).measure(), name);
}

/// Advances the world through the frames of the checks and `frames` without drawing. Returns the results of
/// all checks.
std::vector<golden::CheckResult> run(const scene::Scene& scene, const std::vector<int>& frames) {
  sim::World world(scene);
  golden::Checker checker(scene, world, frames);
  std::vector<int> all = checker.frames();
  all.insert(all.end(), frames.begin(), frames.end());
  std::sort(all.begin(), all.end());
  for (const int frame : all) {
    world.advanceTo(frame);
    checker.state(frame, world);
  }
  return checker.results();
}

/// Returns the message of the last check result, or an empty text if that check passed.
std::string messageOf(const scene::Scene& scene, const std::vector<int>& frames) {
  const auto results = run(scene, frames);
  REQUIRE(!results.empty());
  CHECK(results.back().passed == results.back().message.empty());
  return results.back().message;
}

/// Constructs a Checker for `scene`. Returns the error message, or an empty text if construction succeeds.
std::string refusal(const scene::Scene& scene, const std::vector<int>& tested) {
  const sim::World world(scene);
  try {
    const golden::Checker checker(scene, world, tested);
    return "";
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
}

}  // namespace

TEST_CASE("checks: a falling cloth has the energy of semi-implicit Euler") {
  testContext();
  const auto scene = falling("");
  sim::World world(scene);
  const double dt = 1.0 / 240;
  const double g = 9.8F;
  const double mass = 12 * 8 * 0.25;
  for (const int frame : {0, 30, 60}) {
    world.advanceTo(frame);
    INFO("frame ", frame);
    // Solution of semi-implicit Euler after n substeps: v = -g n dt, y = y0 - g dt^2 n (n + 1) / 2. The
    // energy is therefore m g y0 - m g^2 dt^2 n / 2.
    const double n = frame * 4;
    const double speed = g * n * dt;
    CHECK(quantity(world, scene, "population") == 96);
    CHECK(quantity(world, scene, "mass") == mass);
    CHECK(quantity(world, scene, "speed") == doctest::Approx(speed).epsilon(1e-5));
    CHECK(quantity(world, scene, "kineticEnergy") ==
          doctest::Approx(0.5 * mass * speed * speed).epsilon(1e-5));
    CHECK(quantity(world, scene, "potentialEnergy") ==
          doctest::Approx(mass * g * (10 - g * dt * dt * n * (n + 1) / 2)).epsilon(1e-5));
    CHECK(quantity(world, scene, "energy") ==
          doctest::Approx(mass * (g * 10 - g * g * dt * dt * n / 2)).epsilon(1e-5));
    CHECK(quantity(world, scene, "stretch") == doctest::Approx(1).epsilon(1e-4));
  }
}

TEST_CASE("checks: statistics of a falling cloth equal semi-implicit Euler") {
  testContext();
  const auto results = run(falling(R"({"what": "mean", "of": "positions.y", "min": -100},
                                      {"what": "min", "of": "velocities.y", "max": 0},
                                      {"what": "max", "of": "velocities.length", "min": 0},
                                      {"what": "sum", "of": "positions.w", "min": 384, "max": 384})"),
                           {30});
  REQUIRE(results.size() == 4);
  const double n = 120;
  const double dt = 1.0 / 240;
  CHECK(results[0].what == "mean of sheet positions.y");
  CHECK(*results[0].value == doctest::Approx(10 - 9.8 * dt * dt * n * (n + 1) / 2).epsilon(1e-6));
  CHECK(*results[1].value == doctest::Approx(-9.8 * n * dt).epsilon(1e-5));
  CHECK(*results[2].value == doctest::Approx(9.8 * n * dt).epsilon(1e-5));
  CHECK(*results[3].value == 384);  // positions.w holds inverse masses, which sum to 96 particles times 1 /
                                    // (0.25 kg)
  for (const golden::CheckResult& result : results) CHECK(result.passed);
}

TEST_CASE("checks: pins that stretch a cloth store elastic energy") {
  testContext();
  const auto scene = sceneOf(R"("sheet": {"cloth": {"size": [3, 2], "spacing": 0.5, "stiffness": 16,
      "shear": 0.5, "bend": 0.25, "pins": [{"rows": [0, 1], "scale": [1.5, 1, 1]}]}})",
                             "");
  sim::World world(scene);
  CHECK(quantity(world, scene, "elasticEnergy") == doctest::Approx(0).epsilon(1e-9));
  world.advanceTo(1);
  // 4 springs along x are 0.25 m longer, 4 diagonals are longer, and 2 bending springs across two cells are
  // 0.5 m longer.
  const double diagonal = std::sqrt(0.8125) - std::sqrt(0.5);
  const double expected = 4 * 0.5 * 16 * 0.0625 + 4 * 0.5 * 8 * diagonal * diagonal + 2 * 0.5 * 4 * 0.25;
  // The positions include a rotation of sheet and pins by 0 degrees, for which exactCos returns 1 - 1.2e-7.
  CHECK(quantity(world, scene, "elasticEnergy") == doctest::Approx(expected).epsilon(1e-5));
  CHECK(quantity(world, scene, "stretch") == doctest::Approx(1.5).epsilon(1e-6));
  CHECK(quantity(world, scene, "kineticEnergy") == 0);
}

TEST_CASE("checks: potential energy uses the gravity at the state's time") {
  testContext();
  const auto scene = sceneOf(R"("sheet": {"cloth": {"size": [4, 4], "mass": 0.5, "position": [0, 2, 0],
      "pins": [{"rows": [0, 1, 2, 3]}], "gravity": {"keys": [[0, [0, 0, 0]], [2, [0, -8, 0]]]}}})",
                             "");
  sim::World world(scene);
  CHECK(quantity(world, scene, "potentialEnergy") == 0);
  world.advanceTo(60);  // gravity at 1 s is 4 m/s^2
  CHECK(quantity(world, scene, "potentialEnergy") == doctest::Approx(16 * 0.5 * 4 * 2).epsilon(1e-6));
}

TEST_CASE("checks: a value below \"min\" or above \"max\" fails with a message") {
  testContext();
  const std::vector<int> frames = {0, 30};
  CHECK(messageOf(falling(R"({"what": "mass", "min": 24, "max": 24})"), frames).empty());
  CHECK(messageOf(falling(R"({"what": "mass", "min": 24.5})"), frames) ==
        "frame 30: mass of sheet is 24, below 24.5");
  CHECK(messageOf(falling(R"({"what": "mass", "max": 23})"), frames) ==
        "frame 30: mass of sheet is 24, above 23");
  CHECK(messageOf(falling(R"({"what": "max", "of": "positions.w", "object": "sheet", "max": 3})"),
                  frames) == "frame 30: max of sheet positions.w is 4, above 3");
}

TEST_CASE("checks: drift is relative to the first of the check's frames") {
  testContext();
  // The energy m g y0 decreases by m g^2 dt^2 n / 2 in n substeps, which is a fraction of 0.00102 at frame
  // 30. Without spring forces or gravity, the decrease would be larger.
  CHECK(messageOf(falling(R"({"what": "energy", "drift": 0.0011})"), {0, 30}).empty());
  const std::string message = messageOf(falling(R"({"what": "energy", "drift": 0.0009})"), {0, 30});
  INFO(message);
  CHECK(message.find("frame 30: energy of sheet is 2349.") == 0);
  CHECK(message.find(" away from 2352") != std::string::npos);
  CHECK(message.find(" at frame 0; drift 0.0009 allows 2.12") != std::string::npos);
  // From frame 29 to frame 30, the drift is much smaller.
  CHECK(messageOf(falling(R"({"what": "energy", "drift": 0.0001, "frames": [29, 30]})"), {0, 30}).empty());

  const auto results = run(falling(R"({"what": "energy", "min": 2351.9, "drift": 0.5})"), {0, 1});
  REQUIRE(results.size() == 2);
  CHECK(results[1].min == 2351.9);  // `min` is tighter than the lower bound from `drift`
  CHECK(*results[1].max == doctest::Approx(1.5 * 2352).epsilon(1e-5));
}

TEST_CASE("checks: checks at untested frames are evaluated without drawing a picture") {
  testContext();
  const auto scene = falling(R"({"what": "mass", "min": 1, "frames": [3, 10]}, {"what": "no-nan"},
                                {"what": "energy", "drift": 1, "frames": [5, 10, 12]})");
  const sim::World world(scene);
  const std::vector<int> tested = {0, 10};
  CHECK(golden::Checker(scene, world, tested).frames() == std::vector<int>{3, 5, 12});
  const auto results = run(scene, tested);
  std::vector<std::string> got;
  got.reserve(results.size());
  for (const auto& result : results) got.push_back(fmt::format("{} {}", result.frame, result.what));
  CHECK(got == std::vector<std::string>{"0 no-nan", "3 mass of sheet", "5 energy of sheet",
                                        "10 mass of sheet", "10 no-nan", "10 energy of sheet",
                                        "12 energy of sheet"});
}

TEST_CASE("checks: a NaN in the state fails the check and is named") {
  testContext();
  const auto scene = falling(R"({"what": "no-nan"}, {"what": "no-nan", "object": "sheet"},
                                {"what": "energy", "max": 1e9}, {"what": "max", "of": "velocities.z", "max": 9})");
  const sim::World world(scene);
  const std::vector<int> tested = {0};
  const auto resultsWith = [&](const char* array, std::size_t component, float value) {
    for (const sim::StateArray& state : world.object(0).state())
      if (std::string(array) == state.name)
        glNamedBufferSubData(state.buffer->name(), static_cast<GLintptr>((17 * 4 + component) * 4), 4,
                             &value);
    golden::Checker checker(scene, world, tested);
    checker.state(0, world);
    return checker.results();
  };
  for (const auto& result : resultsWith("velocities", 2, 0.5F)) CHECK(result.message.empty());
  const auto lost = resultsWith("velocities", 2, std::numeric_limits<float>::quiet_NaN());
  CHECK(lost[0].message == "frame 0: velocities[17].z of sheet is NaN");
  CHECK(lost[0].value == 1.0);
  CHECK(lost[1].what == "no-nan of sheet");
  CHECK(!lost[1].passed);
  CHECK(lost[2].message == "frame 0: energy of sheet is not a finite number");
  CHECK(lost[3].message == "frame 0: max of sheet velocities.z is not a finite number");
  const auto more = resultsWith("positions", 0, std::numeric_limits<float>::infinity());
  CHECK(more[0].message ==
        "frame 0: positions[17].x of sheet is infinite, and 1 more number is not finite");
}

TEST_CASE("checks: \"not-blank\" fails for a picture of one colour") {
  testContext();
  const auto scene = falling(R"({"what": "not-blank"})");
  const sim::World world(scene);
  const std::vector<int> tested = {0};
  const auto messageWith = [&](std::uint8_t onePixel) {
    frame::Image image{10, 10, std::vector<std::uint8_t>(400, 80)};
    for (std::size_t c = 0; c < 3; ++c) image.bytes[200 + c] = onePixel;
    golden::Checker checker(scene, world, tested);
    checker.state(0, world);
    checker.picture(0, image);
    CHECK(checker.results().at(0).what == "not-blank");
    return checker.results().at(0).message;
  };
  CHECK(messageWith(80) == "frame 0: the picture is one colour");
  // One pixel of 100 differs by d, so the standard deviation is d sqrt(0.01 * 0.99) = 0.0995 d.
  CHECK(messageWith(90) ==
        "frame 0: the picture is nearly one colour: the standard deviation of its luma is 0.0039, below "
        "0.00392");
  CHECK(messageWith(91).empty());
}

TEST_CASE("checks: an unknown array, object or component is refused with the valid names") {
  testContext();
  const std::vector<int> tested = {0, 9};
  CHECK(refusal(falling(R"({"what": "max", "of": "position.y", "max": 1})"), tested) ==
        "checks[0]: no object of the scene has an array named \"position\"; did you mean \"positions\"?");
  CHECK(refusal(falling(R"({"what": "no-nan", "object": "ball"})"), tested) ==
        "checks[0]: object \"ball\" is a sphere, which has no state to check");
  CHECK(refusal(sceneOf(R"("ball": {"sphere": {}})", R"({"what": "no-nan"})"), tested) ==
        "checks[0]: \"no-nan\" checks the state of simulations, but no object of the scene has state");
  CHECK(refusal(falling(R"({"what": "not-blank", "frames": [0, 59]})"), tested) ==
        "checks[0]: \"not-blank\" needs a picture of frame 59, which is not tested; tested: 0, 9");
  CHECK(refusal(falling(R"({"what": "not-blank"}, {"what": "mass", "max": 1})"), tested).empty());
  // Sets the checks in memory, because the scene reader would reject the mistakes below.
  auto made = falling("");
  made.checks.resize(1);
  made.checks[0].what = "max";
  made.checks[0].of = "positions.q";
  CHECK(refusal(made, tested) ==
        "checks[0]: \"positions.q\" has no component \"q\"; known here: x, y, z, w, length");
  made.checks[0].of = "positions.y";
  made.checks[0].object = "shet";
  CHECK(refusal(made, tested) == "checks[0]: no object is named \"shet\"; did you mean \"sheet\"?");
}

TEST_CASE("checks: every object kind measures as many quantities as it declares") {
  testContext();
  const std::map<std::string, std::string> needs = {
      {"arrows", R"("of": "wind")"},
      {"particles", R"("groups": [{}])"},
      {"body", R"("file": "meshes/walker.gltf")"},
      {"chart", R"("curves": [{"of": "cells.population"}])"},
      {"colorBar", R"("of": "cells")"},
      {"contour", R"("field": "cells")"},
      {"epidemic", R"("infected": 0.01)"},
      {"image", R"("file": "kernels/Folds.frag", "size": [8, 8])"},
      {"isolines", R"("of": "cells")"},
      {"kernels",
       R"("file": "kernels/GameOfLife.compute", "textures": {"_Current": [8, 8], "_Next": [8, 8]}, "constants": {"_Width": 8, "_Height": 8})"},
      {"mesh", R"("deform": [{"ripple": {}}])"},
      {"reaction", R"("preset": "barkley")"},
      {"streamlines", R"("of": "wind")"},
      {"wildfire", R"("strokes": [{"from": [9, 9, 0]}])"}};
  for (const scene::Kind& kind : sim::kinds().list) {
    CAPTURE(std::string(kind.name));
    const auto given = needs.find(kind.name);
    const auto scene =
        sceneOf(fmt::format(R"("a": {{"{}": {{{}}}}}, "cells": {{"life": {{}}}}, "wind": {{"flow": {{}}}})",
                            kind.name, given == needs.end() ? "" : given->second),
                "");
    const sim::World world(scene);
    CHECK(scene.objects[0].parameters->measures() == !scene.objects[0].parameters->quantities().empty());
    CHECK(world.object(0).measure().size() == scene.objects[0].parameters->quantities().size());
  }
  CHECK_THROWS_WITH_AS(sceneOf(R"("a": {"mesh": {}})", R"({"what": "area", "max": 1})"),
                       doctest::Contains("no object of the scene has a quantity \"area\""), UserError);
}

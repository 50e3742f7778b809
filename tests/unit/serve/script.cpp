#include "serve/script/script.hpp"

#include <memory>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::serve;

namespace {

std::shared_ptr<Script> scriptOf(const std::string& objects, const std::string& more = {}) {
  return readScript({"scene.json", {}, {}},
                    R"({"version": 1, )" + more + R"("objects": {)" + objects + "}}", {});
}

const std::string lit = R"("stage": false, "camera": {"position": [0, 1, 3], "target": [0, 0, 0]}, )";

}  // namespace

TEST_CASE("a renderer is reused for another script only if camera, stage and materials are equal") {
  const auto alike = [](const std::string& before, const std::string& after, const std::string& more) {
    return drawsAlike(*scriptOf(before, more), *scriptOf(after, more));
  };
  const std::string ball = R"("a": {"sphere": {"radius": 0.5}})",
                    larger = R"("a": {"sphere": {"radius": 0.8}})";
  CHECK_FALSE(alike(ball, larger, ""));
  CHECK_FALSE(alike(ball, larger, R"("stage": false, )"));  // The camera is placed according to the extent
                                                            // of the ball.
  CHECK_FALSE(
      alike(ball, larger,
            R"("camera": {"position": [0, 1, 3], "target": [0, 0, 0]}, )"));  // The ground is placed
                                                                              // according to the extent
                                                                              // of the ball.
  CHECK(alike(ball, larger, lit));
  const auto cloth = [](const std::string& value) {
    return R"("flag": {"cloth": {"size": [8, 8], )" + value + "}}";
  };
  CHECK(alike(cloth(R"("substeps": 8)"), cloth(R"("substeps": 9)"), ""));
  // These scenes have different objects.
  CHECK_FALSE(alike(ball, R"("a": {"capsule": {}})", lit));
  CHECK_FALSE(alike(ball, ball + R"(, "b": {"sphere": {}})", lit));
}

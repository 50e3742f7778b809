// Tests cameras of glTF files. Position and rotation must be correct, and each error must give a clear
// one-line message.
#include "sim/nodes/camera_shot.hpp"

#include "base/error.hpp"
#include "draw/camera.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"
#include "unit/figure_text.hpp"
#include "unit/help.hpp"

#include <cmath>
#include <filesystem>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>

using namespace simreel;
using simreel::test::checkHas;
using simreel::test::TemporaryFile;

namespace {

constexpr double eighth = 0.70710678118654752;

/// Returns the text of a glTF file. It has an arm, moved by (0, 0, 4) m and scaled by (2, 2, 3), that
/// rotates about y from 0 to 90 degrees between 1 and 3 s. A camera "wide" with a vertical angle of 60
/// degrees is at (0.5, 0, 0) on the arm. The file also has an orthographic camera "flat".
test::GltfText shotText() {
  test::GltfText gltf;
  auto& d = gltf.document;
  d["scene"] = 0;
  d["scenes"] = {{{"nodes", {0, 2}}}};
  d["nodes"] = {{{"name", "arm"}, {"children", {1}}, {"translation", {0, 0, 4}}, {"scale", {2, 2, 3}}},
                {{"name", "wide"}, {"camera", 0}, {"translation", {0.5, 0, 0}}},
                {{"name", "flat"}, {"camera", 1}}};
  d["cameras"] = {{{"type", "perspective"},
                   {"name", "lens"},
                   {"perspective", {{"yfov", 1.0471975511965976}, {"znear", 0.2}, {"aspectRatio", 9}}}},
                  {{"type", "orthographic"},
                   {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 9}}}}};
  const std::size_t times = gltf.floats({1, 3}, "SCALAR", 1);
  const std::size_t turns =
      gltf.floats({0, 0, 0, 1, 0, static_cast<float>(eighth), 0, static_cast<float>(eighth)}, "VEC4", 4);
  const std::size_t moves = gltf.floats({0, 0, 0, 0, 9, 0}, "VEC3", 3);
  d["animations"] = {{{"name", "other"},
                      {"samplers", {{{"input", times}, {"output", moves}}}},
                      {"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}}}}},
                     {{"name", "turn"},
                      {"samplers", {{{"input", times}, {"output", turns}}}},
                      {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}}};
  return gltf;
}

scene::CameraFile asked(const std::string& name) {
  scene::CameraFile wanted;
  wanted.file = "shot.gltf";
  wanted.name = name;
  return wanted;
}

std::string mistakeOf(const scene::CameraFile& wanted, const test::GltfText& gltf) {
  try {
    static_cast<void>(sim::readCamera(wanted, gltf.text()));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("glTF cameras: a camera follows its node and its ancestors, without their scale") {
  const auto shot = sim::readCamera(asked("wide"), shotText().text());
  CHECK(shot->fieldOfView() == doctest::Approx(60));
  CHECK(shot->near() == 0.2);
  CHECK(!shot->far());
  for (const double time : {0.0, 1.0, 1.7, 2.0, 3.0, 8.0}) {
    CAPTURE(time);
    // The arm rotates x towards -z. The camera is 1 m from the rotation axis.
    const double angle = std::min(std::max((time - 1) / 2, 0.0), 1.0) * 1.5707963267948966;
    const glm::dvec3 right(std::cos(angle), 0, -std::sin(angle)), back(std::sin(angle), 0, std::cos(angle));
    const scene::CameraPose pose = shot->at(time);
    CHECK(glm::length(pose.eye - (glm::dvec3(0, 0, 4) + right)) < 1e-6);
    CHECK(glm::length(pose.right - right) < 1e-6);
    CHECK(glm::length(pose.up - glm::dvec3(0, 1, 0)) < 1e-6);
    CHECK(glm::length(pose.back - back) < 1e-6);
  }
  scene::CameraFile still = asked("lens");  // This name is the name of the camera, not the name of its
                                            // node.
  still.animation = "other";
  CHECK(glm::length(sim::readCamera(still, shotText().text())->at(2).eye - glm::dvec3(1, 0, 4)) < 1e-6);
  scene::CameraFile fast = asked("wide");
  fast.speed = 2;
  fast.start = -1;
  fast.loop = true;
  const auto round = sim::readCamera(fast, shotText().text());
  CHECK(glm::length(round->at(1.35).eye - shot->at(1.7).eye) < 1e-6);
  CHECK(glm::length(round->at(2.85).eye - shot->at(1.7).eye) < 1e-6);
}

TEST_CASE("glTF cameras: the view has the file's field of view and the picture's aspect ratio") {
  scene::Camera camera;
  camera.gltf.emplace();
  camera.gltf->shot = sim::readCamera(asked("wide"), shotText().text());
  camera.gltf->distance = 3;
  camera.fieldOfView = static_cast<float>(camera.gltf->shot->fieldOfView());
  const draw::View view = draw::viewAt(camera, 3, {300, 100}, {});
  CHECK(glm::length(view.forward - glm::vec3(-1, 0, 0)) < 1e-6F);
  CHECK(glm::length(view.target - glm::vec3(-3, 0, 3)) < 1e-5F);
  CHECK(view.reach.y == doctest::Approx(std::tan(0.5235987755982988)));
  CHECK(view.reach.x == doctest::Approx(3 * std::tan(0.5235987755982988)));
  CHECK(glm::length(glm::normalize(view.right) - glm::vec3(0, 0, -1)) < 1e-6F);
}

TEST_CASE("glTF cameras: an orthographic camera shows the file's extent along parallel rays") {
  const TemporaryFile file("shot.gltf", shotText().text());
  const auto parsed = [&](const std::string& more) {
    return scene::parseScene(
        fmt::format(R"({{"version": 1, "camera": {{"gltf": {{"file": "{}", "name": "flat"}}{}}}}})",
                    file.path().filename().string(), more),
        file.path().parent_path() / "scene.json", {}, sim::kinds());
  };
  const scene::Camera camera = parsed("").camera;
  CHECK(camera.projection == scene::Projection::orthographic);
  CHECK(camera.height.at(0) == 2);
  CHECK(camera.near == 0.1F);
  CHECK(camera.far == 9);
  const draw::View view = draw::viewAt(camera, 0, {300, 100}, {});
  CHECK(view.parallel);
  CHECK(glm::length(view.up - glm::vec3(0, 1, 0)) < 1e-6F);
  CHECK(glm::length(view.right - glm::vec3(3, 0, 0)) < 1e-6F);
  CHECK(parsed(R"(, "height": 5)").camera.height.at(0) == 5);
  for (const auto& [more, said] :
       {std::pair(R"(, "fieldOfView": 30)", "orthographic, which has no \"fieldOfView\""),
        std::pair(R"(, "lens": true)", "orthographic, which has no \"lens\""),
        std::pair(R"(, "projection": "perspective")", "leave out \"projection\"")}) {
    std::string message = "none";
    try {
      static_cast<void>(parsed(more));
    } catch (const UserError& error) {
      message = error.what();
    }
    checkHas(message, said);
  }
}

TEST_CASE("glTF cameras: invalid cameras are reported") {
  const test::GltfText gltf = shotText();
  checkHas(mistakeOf(asked(""), gltf), "has 2 cameras; say which by its \"name\": flat, wide");
  checkHas(mistakeOf(asked("wid"), gltf), "has no camera \"wid\"; did you mean \"wide\"?");
  scene::CameraFile moved = asked("wide");
  moved.animation = "tur";
  checkHas(mistakeOf(moved, gltf), "no animation \"tur\"; did you mean \"turn\"?");
  test::GltfText none = gltf, narrow = gltf, nothing = gltf, level = gltf, strange = gltf;
  level.document["cameras"][1]["orthographic"]["ymag"] = 0;
  checkHas(mistakeOf(asked("flat"), level), "\"flat\" of the file has a view 0 m high");
  strange.document["cameras"][1]["type"] = "fisheye";
  try {
    static_cast<void>(sim::readCamera(asked("flat"), strange.text()));
    CHECK(false);
  } catch (const UserError& error) {
    checkHas(error.what(), "a camera of type \"fisheye\"");
  }
  none.document["scenes"][0]["nodes"] = {2};
  none.document["nodes"][2].erase("camera");
  checkHas(mistakeOf(asked(""), none), "has no camera in its default scene");
  narrow.document["cameras"][0]["perspective"]["yfov"] = 3.1;
  checkHas(mistakeOf(asked("wide"), narrow), "has a field of view of 177.6 degrees");
  nothing.document["nodes"][0]["scale"] = {0, 1, 0};
  CHECK_THROWS_WITH_AS(static_cast<void>(sim::readCamera(asked("wide"), nothing.text())->at(0.5)),
                       "camera \"wide\" of the file has no direction at 0.5 s: the scale of a node is "
                       "close to 0 or too large",
                       UserError);
}

TEST_CASE("glTF cameras: a scene uses the file's field of view, near and far unless it gives its own") {
  test::GltfText gltf = shotText();
  gltf.document["cameras"][0]["perspective"]["zfar"] = 70;
  const TemporaryFile file("shot.gltf", gltf.text());
  const auto parsed = [&](const std::string& more) {
    return scene::parseScene(
        fmt::format(R"({{"version": 1, "camera": {{"gltf": {{"file": "{}", "name": "wide"}}{}}}}})",
                    file.path().filename().string(), more),
        file.path().parent_path() / "scene.json", {}, sim::kinds());
  };
  const scene::Camera camera = parsed("").camera;
  CHECK(camera.fieldOfView.at(0) == doctest::Approx(60));
  CHECK(camera.near == 0.2F);
  CHECK(camera.far == 70);
  const scene::Camera own = parsed(R"(, "fieldOfView": 30, "near": 1, "far": 2)").camera;
  CHECK(own.fieldOfView.at(0) == 30);
  CHECK(own.near == 1);
  CHECK(own.far == 2);
  for (const auto& [more, said] :
       {std::pair(R"(, "near": 80)", "\"near\" is 80 m and \"far\" 70 m; give both"),
        std::pair(R"(, "target": [0, 0, 0])", "leave out \"target\""),
        std::pair(R"(, "orbit": {})", "leave out \"orbit\"")}) {
    std::string message = "none";
    try {
      static_cast<void>(parsed(more));
    } catch (const UserError& error) {
      message = error.what();
    }
    checkHas(message, said);
  }
}

// Tests files with skeletons. Their supported content must be read, and each error must give a clear
// one-line message.
#include "base/error.hpp"
#include "scene/load.hpp"
#include "sim/body/figure.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"
#include "source_folder.hpp"
#include "unit/figure_text.hpp"
#include "unit/help.hpp"

#include <filesystem>
#include <functional>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;
using simreel::test::checkHas;
using simreel::test::TemporaryFile;
using simreel::test::TubeFaults;

namespace {

std::string figureFailure(const std::string& text) {
  const TemporaryFile file("tube.gltf", text);
  try {
    static_cast<void>(sim::loadFigure(file.path()));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::inputOutput);
    const std::string message = error.what();
    CHECK(message.find(file.path().string()) != std::string::npos);
    CHECK(message.find('\n') == std::string::npos);
    return message;
  }
  return "no failure";
}

std::string figureFailure(const TubeFaults& faults) {
  return figureFailure(tubeText(faults).text());
}

/// Returns the first error of a scene with a body of this file, or "none".
std::string problemOf(const std::string& objects) {
  const scene::Scene scene =
      scene::parseScene(fmt::format(R"({{"version": 1, "objects": {{{}}}}})", objects),
                        std::filesystem::temp_directory_path() / "test.json", {}, sim::kinds());
  const auto problems = sim::findProblems(scene);
  return problems.empty() ? "none" : problems.front().what();
}

}  // namespace

TEST_CASE("body: a tube is read with its bones, weights and motions") {
  const TemporaryFile file("tube.gltf", test::tubeText().text());
  const sim::Figure figure = sim::loadFigure(file.path());
  CHECK(figure.mesh.positions.size() == 24 * 41);
  CHECK(figure.mesh.indices.size() == 24 * 40 * 6);
  CHECK(figure.follow.size() == figure.mesh.positions.size());
  CHECK(figure.joints.size() == 3);
  CHECK(figure.nodes.size() == 4);
  for (const glm::vec4& w : figure.weights) CHECK(w.x + w.y + w.z + w.w == doctest::Approx(1));
  REQUIRE(figure.animations.size() == 3);
  CHECK(figure.animations[0].name == "bend");
  CHECK(figure.animations[0].seconds == 1);
  const int high = figure.nodeNamed("high", "body");
  CHECK(figure.nodes[static_cast<std::size_t>(high)].parent == figure.nodeNamed("low", "body"));
}

TEST_CASE("body: a file without normals is flat shaded") {
  auto gltf = test::tubeText();
  gltf.document["meshes"][0]["primitives"][0]["attributes"].erase("NORMAL");
  const TemporaryFile file("tube.gltf", gltf.text());
  const sim::Figure figure = sim::loadFigure(file.path());
  CHECK(figure.mesh.positions.size() == 2 * 24 * 41);  // 24 flat strips with 2 x 41 vertices each
  CHECK(figure.follow.size() == figure.mesh.positions.size());
}

TEST_CASE("body: byte and short weights are read, and a mesh without a skin follows its node") {
  auto gltf = test::tubeText();
  std::vector<std::uint8_t> weights;
  for (int i = 0; i < 24 * 41; ++i) weights.insert(weights.end(), {100, 155, 0, 0});
  auto& primitive = gltf.document["meshes"][0]["primitives"][0];
  primitive["attributes"]["WEIGHTS_0"] = gltf.add(weights, 5121, "VEC4", 4, true);
  gltf.document["nodes"].push_back({{"name", "hat"}, {"mesh", 0}});
  gltf.document["nodes"][2]["children"] = {4};
  const TemporaryFile file("tube.gltf", gltf.text());
  const sim::Figure figure = sim::loadFigure(file.path());
  CHECK(figure.mesh.positions.size() == 2 * 24 * 41);
  std::size_t worn = 0;
  for (std::size_t i = 0; i < figure.weights.size(); ++i) {
    const bool whole = figure.weights[i].x == 1;
    worn += whole ? 1 : 0;
    if (whole)
      CHECK(figure.nodes[static_cast<std::size_t>(figure.joints[figure.follow[i].x].node)].name == "hat");
    if (!whole) CHECK(figure.weights[i].y == doctest::Approx(155.0 / 255));
  }
  CHECK(worn == 24 * 41);
}

TEST_CASE("body: each file error is one line with its place") {
  checkHas(figureFailure(TubeFaults{.noSkin = true}), "neither a skin nor a moving mesh");
  checkHas(figureFailure(TubeFaults{.noWeights = true}), "mesh 0, which has no WEIGHTS_0");
  checkHas(figureFailure(TubeFaults{.noJoints = true}), "mesh 0, which has no JOINTS_0");
  checkHas(figureFailure(TubeFaults{.weightSum = 0.9F}), "vertex 0 has weights with the sum 0.9");
  checkHas(figureFailure(TubeFaults{.joint = 3}), "follows joint 3, its skin has 3");
  checkHas(figureFailure(TubeFaults{.times = {0, 1, 1}}),
           "\"bend\" that moves \"high\" at 1 s (key 2): times must be 0 or more and increase");
  CHECK(figureFailure(TubeFaults{.weightSum = 0.99F}) == "no failure");
  const auto changed = [](const std::function<void(nlohmann::json&)>& change) {
    auto gltf = test::tubeText();
    change(gltf.document);
    return figureFailure(gltf.text());
  };
  checkHas(changed([](auto& d) { d["skins"][0]["joints"] = {0, 1, 9}; }), "whose joint 2 is node 9");
  checkHas(changed([](auto& d) { d["nodes"][3]["skin"] = 1; }), "names number 1 of its 1 skins");
  checkHas(changed([](auto& d) {
             d["skins"][0]["joints"] = {0, 1, 2, 3};
           }),
           "4 joints with 3 inverse bind");
  checkHas(changed([](auto& d) { d["nodes"][2]["children"] = {0}; }), "two parents");
  checkHas(changed([](auto& d) { d["animations"][0]["channels"][0]["target"]["path"] = "colour"; }),
           "along \"colour\", which is not a property that glTF animates");
  checkHas(changed([](auto& d) { d["animations"][1]["samplers"][0]["interpolation"] = "CUBIC"; }),
           "interpolation \"CUBIC\"");
  checkHas(changed([](auto& d) { d["animations"][1]["samplers"][0]["interpolation"] = "CUBICSPLINE"; }),
           "by 3 values at 3 times");
  checkHas(changed([](auto& d) { d["animations"][0]["channels"][0]["sampler"] = 7; }), "valid glTF");
}

TEST_CASE("body: any damaged file is read or refused in one line") {
  auto gltf = test::tubeText();
  nlohmann::json whole = nlohmann::json::parse(gltf.text());
  std::vector<nlohmann::json::json_pointer> leaves;
  const nlohmann::json flat = whole.flatten();
  for (const auto& [path, value] : flat.items())
    if (!value.is_string() || path.find("uri") == std::string::npos) leaves.emplace_back(path);
  CHECK(leaves.size() > 100);
  int refused = 0;
  int astray = 0;
  for (const auto& leaf : leaves)
    for (const char* wrong : {"-1", "7", "1e9", "\"x\"", "null"}) {
      nlohmann::json changed = whole;
      changed[leaf] = nlohmann::json::parse(wrong);
      try {
        const sim::Figure figure = sim::readFigure("tube.gltf", changed.dump());
        for (const glm::uvec4& follow : figure.follow)
          for (int k = 0; k < 4; ++k) astray += follow[k] < figure.joints.size() ? 0 : 1;
      } catch (const UserError& error) {
        ++refused;
        CHECK(std::string(error.what()).find('\n') == std::string::npos);
      }
    }
  CHECK(refused > 300);
  CHECK(astray == 0);
}

TEST_CASE("body: unknown names are reported with the available names") {
  const TemporaryFile file("tube.gltf", test::tubeText().text());
  const std::string body = fmt::format(R"("tube": {{"body": {{"file": "{}" )", file.path().string());
  CHECK(problemOf(body + R"(, "animation": "bend", "collides": true}})") == "none");
  checkHas(problemOf(body + R"(, "animation": "wave"}})"),
           "body \"tube\": its file has no animation \"wave\"");
  checkHas(problemOf(body + R"(, "bones": [{"bone": "hihg"}]}})"),
           "no bone \"hihg\"; did you mean \"high\"");
  const std::string pinned =
      R"(}}, "cape": {"cloth": {"pins": [{"rows": [0], "to": "%", "bone": "high"}]}})";
  const auto tied = [&](const char* to) {
    std::string text = body + pinned;
    text.replace(text.find('%'), 1, to);
    return problemOf(text);
  };
  CHECK(tied("tube") == "none");
  try {
    static_cast<void>(tied("tub"));
    FAIL("nothing was refused");
  } catch (const UserError& error) {
    checkHas(error.what(), "no object is named \"tub\"");
    checkHas(error.what(), "did you mean \"tube\"");
    checkHas(error.what(), "pins");
    checkHas(error.what(), "^~~~~");  // The marks are below the name, which is an item of a list.
    CHECK(std::string(error.what()).find("^~~~~~") == std::string::npos);
  }
  std::string unknown = body + pinned;
  unknown.replace(unknown.find('%'), 1, "tube");
  unknown.replace(unknown.find("\"high\""), 6, "\"neck\"");
  checkHas(problemOf(unknown), "body \"tube\": its file has no bone \"neck\"");
  const TemporaryFile flat("flat.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  checkHas(problemOf(fmt::format(R"("b": {{"body": {{"file": "{}"}}}})", flat.path().string())),
           "neither .gltf nor .glb");
}

TEST_CASE("body: the shipped walker is small, closed and walks in a loop") {
  const std::filesystem::path path = sourceFolder() + "/assets/meshes/walker.gltf";
  CHECK(std::filesystem::file_size(path) < 130'000);
  const sim::Figure figure = sim::loadFigure(path);
  CHECK(figure.animationNamed("walk", "").seconds == doctest::Approx(1.1));
  CHECK(figure.animationNamed("idle", "").seconds == doctest::Approx(4));
  double volume = 0;
  for (std::size_t i = 0; i < figure.mesh.indices.size(); i += 3) {
    const glm::dvec3 a(figure.mesh.positions[figure.mesh.indices[i]]);
    const glm::dvec3 b(figure.mesh.positions[figure.mesh.indices[i + 1]]);
    const glm::dvec3 c(figure.mesh.positions[figure.mesh.indices[i + 2]]);
    volume +=
        (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x)) / 6;
  }
  CHECK(volume > 0.05);  // volume in m^3; positive because the faces point outwards
  CHECK(volume < 0.1);
  for (const sim::FigureChannel& channel : figure.animationNamed("walk", "").channels) {
    const std::size_t width = channel.path == sim::FigureChannel::Path::rotation ? 4 : 3;
    for (std::size_t k = 0; k < width; ++k)
      CHECK(channel.values[k] ==
            doctest::Approx(channel.values[channel.values.size() - width + k]).epsilon(1e-4));
  }
}

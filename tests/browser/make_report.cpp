// Writes a report for tests of the page. Usage: make_report FOLDER showcase|bulk N|none. The showcase
// contains every status, and text that must be escaped. The bulk report has N failing scenes of three
// frames.
#include "base/error.hpp"
#include "base/file.hpp"
#include "frame/image.hpp"
#include "golden/report/html.hpp"
#include "pictures.hpp"

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

using namespace simreel;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

constexpr int beyond = 12, window = 16;

/// The encoded pictures of a failed frame, and what a report says about them.
struct Drawn {
  std::vector<std::byte> expected, actual, difference;
  std::string pixels;
  Json metrics;
};

struct Maker {
  fs::path folder;
  int width = 320, height = 180;
  /// By frame and phase. Scenes of a report share frames, so each is drawn once.
  std::map<std::pair<int, double>, Drawn> drawn;

  std::string keep(const std::string& scene, const std::string& file,
                   std::span<const std::byte> png) const {
    fs::create_directories(folder / "files" / scene);
    writeFileAtomically(folder / "files" / scene / file, png);
    return "files/" + scene + "/" + file;
  }
};

Json metricsOf(const frame::Image& a, const frame::Image& b) {
  int worst = 0, worstX = 0, worstY = 0, different = 0, far = 0, max = 0, windowX = 0, windowY = 0;
  double squares = 0;
  std::map<std::pair<int, int>, int> tiles;  // differences summed over overlapping windows, on a grid whose
                                             // spacing is half the window size
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const int much = pixelDifference(a, b, x, y);
      squares += much * much;
      different += much > 0;
      if (much > worst) worst = much, worstX = x, worstY = y;
      if (much <= beyond) continue;
      ++far;
      for (int ty = y / 8 - 1; ty <= y / 8; ++ty)
        for (int tx = x / 8 - 1; tx <= x / 8; ++tx)
          if (const int n = ++tiles[{tx, ty}]; n > max && tx >= 0 && ty >= 0)
            max = n, windowX = tx * 8, windowY = ty * 8;
    }
  const double pixels = double(a.width) * a.height, mean = squares / pixels;
  return {{"worst", worst},
          {"worstX", worstX},
          {"worstY", worstY},
          {"differentPixels", different},
          {"pixelsBeyond", far},
          {"ratioBeyond", far / pixels},
          {"windowRatio", max / double(window * window)},
          {"windowX", windowX},
          {"windowY", windowY},
          {"psnr", mean == 0 ? Json(nullptr) : Json(10 * std::log10(255.0 * 255.0 / mean))},
          {"ssim", 1 - std::min(0.9, mean / 4000)},
          {"flipMean", std::min(1.0, mean / 9000)}};
}

/// Returns a frame whose pixels equal the baseline's.
Json equalFrame(int frame) {
  const std::string hash = fmt::format("{:032x}", frame * 7919 + 1);
  return {{"frame", frame},        {"time", frame / 60.0},   {"status", "pass"},       {"message", ""},
          {"pixels", hash},        {"expectedPixels", hash}, {"alternate", 0},         {"state", "equal"},
          {"asked", "tolerance"},  {"metrics", {}},          {"expectedImage", ""},    {"actualImage", ""},
          {"differenceImage", ""}, {"flipImage", ""},        {"others", Json::array()}};
}

/// Draws a frame whose wave differs from the wave of the baseline by the phase `shift`.
Drawn drawFrame(int width, int height, int frame, double shift) {
  const auto expected = picture(width, height, frame * 0.05);
  auto actual = picture(width, height, frame * 0.05 + shift);
  // The worst pixel is at the position that a test expects, in the bright sky.
  std::uint8_t* const worst = &actual.bytes[(std::size_t(20) * std::size_t(width) + 100) * 4];
  std::fill(worst, worst + 3, 0);
  return {frame::encodePng(expected, {}), frame::encodePng(actual, {}),
          frame::encodePng(difference(expected, actual), {}), frame::pixelHash(actual),
          metricsOf(expected, actual)};
}

/// Returns a frame whose wave differs from the wave of the baseline by the phase `shift`, and writes the
/// pictures of the frame.
Json failedFrame(Maker& make, const std::string& scene, int frame, double shift) {
  auto found = make.drawn.find({frame, shift});
  if (found == make.drawn.end()) {
    const auto key = std::pair(frame, shift);
    found = make.drawn.emplace(key, drawFrame(make.width, make.height, frame, shift)).first;
  }
  const Drawn& drawn = found->second;
  Json result = equalFrame(frame);
  const std::string number = fmt::format("{:06}", frame);
  result["metrics"] = drawn.metrics;
  result["status"] = "fail";
  result["pixels"] = drawn.pixels;
  result["message"] = fmt::format("frame {}: {:.2f} % of the pixels differ by more than {}, {} % may",
                                  frame, result["metrics"]["ratioBeyond"].get<double>() * 100, beyond, 0.5);
  result["expectedImage"] = make.keep(scene, number + ".expected.png", drawn.expected);
  result["actualImage"] = make.keep(scene, number + ".actual.png", drawn.actual);
  result["differenceImage"] = make.keep(scene, number + ".difference.png", drawn.difference);
  return result;
}

Json emptyScene(const std::string& name, const char* status) {
  return {{"name", name},
          {"file", "scenes/" + name + ".json"},
          {"baselines", "scenes/golden/" + name},
          {"status", status},
          {"messages", Json::array()},
          {"notes", Json::array()},
          {"xfail", ""},
          {"profile", "llvmpipe"},
          {"asked", "tolerance"},
          {"baselineDriver", "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5"},
          {"baselineProcessor", "Testium 3, family 6"},
          {"baselineVersion", "0.1.0"},
          {"baselineReason", "first baseline"},
          {"tolerance",
           {{"maxChannelDiff", {{"value", beyond}, {"origin", "default"}}},
            {"maxDiffRatio", {{"value", 0.005}, {"origin", "scenes/" + name + ".json"}}}}},
          {"seconds", 1.25},
          {"simulateSeconds", 0.75},
          {"repeats", 1},
          {"attempts", Json::array()},
          {"frames", Json::array()},
          {"checks", Json::array()},
          {"divergence", {}},
          {"candidate", ""},
          {"renamedFrom", ""}};
}

Json passedScene(const std::string& name, const char* status = "pass") {
  Json scene = emptyScene(name, status);
  for (const int frame : {0, 60, 120}) {
    scene["frames"].push_back(equalFrame(frame));
    scene["frames"].back()["status"] = status;
  }
  return scene;
}

/// Returns a scene whose first frame passes and whose other frames fail by increasing amounts.
Json failedScene(Maker& make, const std::string& name, int frames, int every, double shift) {
  Json scene = emptyScene(name, "fail");
  scene["frames"].push_back(equalFrame(0));
  for (int i = 1; i < frames; ++i) {
    scene["frames"].push_back(failedFrame(make, name, i * every, shift * i / frames));
    scene["messages"].push_back(scene["frames"].back()["message"]);
  }
  scene["candidate"] = "files/" + name + "/candidate";
  return scene;
}

Json check(const char* what, int frame, const Json& value, const Json& min, const Json& max, bool passed,
           const char* message) {
  return {{"what", what}, {"frame", frame},   {"value", value},    {"least", min},
          {"most", max},  {"passed", passed}, {"message", message}};
}

Json flagScene(Maker& make) {
  Json scene = failedScene(make, "cloth/flag", 9, 30, 0.5);
  scene["frames"][1] = equalFrame(30);
  scene["messages"].erase(0);
  scene["messages"].insert(scene["messages"].begin(),
                           "flag.positions first differs at frame 37, step 4 of 22, elements 128 to 191");
  scene["divergence"] = {
      {"frame", 37},
      {"step", 4},
      {"steps", 22},
      {"object", "flag"},
      {"buffer", "positions"},
      {"firstElement", 128},
      {"lastElement", 191},
      {"message", "flag.positions first differs at frame 37, step 4 of 22, elements 128 to 191"}};
  scene["tolerance"]["maxWindowRatio"] = {{"value", 0.9}, {"origin", "--max-window-ratio"}};
  scene["tolerance"]["maxFlipMean"] = {{"value", 0.02},
                                       {"origin", "scenes/golden/cloth/flag/any/baseline.json"}};
  scene["tolerance"]["windowSize"] = {{"value", window}, {"origin", "default"}};
  scene["checks"] = {
      check("no-nan", 240, nullptr, nullptr, nullptr, true, ""),
      check("energy of flag", 60, 3.1, 0, 3, false, "frame 60: energy of flag is 3.1, above 3"),
      check("max of flag positions.y", 240, 2.75, nullptr, 3.2, true, "")};
  scene["notes"] = {"loose tolerance: maxDiffRatio is 0.5, 40 times the 0.0125 observed",
                    "the baseline has frame 300, which is not tested"};
  scene["profile"] = "any";
  scene["messages"].push_back("frame 60: energy of flag is 3.1, above 3");
  return scene;
}

Json nondeterministicScene(Maker& make) {
  Json scene = failedScene(make, "particles/fountain", 2, 60, 0.3);
  scene["status"] = "nondeterministic";
  scene["candidate"] = "";
  scene["repeats"] = 2;
  scene["messages"] = {"runs 1 and 2 of this program differ: the state of frame 60"};
  Json& frame = scene["frames"][1];
  frame["status"] = "nondeterministic";
  frame["message"] = "two runs of this program differ; shown are the first and the second";
  frame["others"] = {{{"label", "run 1"}, {"image", frame["expectedImage"]}},
                     {{"label", "run 2"}, {"image", frame["actualImage"]}}};
  frame["metrics"] = {};
  return scene;
}

Json missingScene(Maker& make) {
  Json scene = failedScene(make, "particles/new", 3, 60, 0.3);
  scene["status"] = "missing";
  scene["profile"] = scene["baselineDriver"] = scene["baselineVersion"] = scene["baselineReason"] = "";
  scene["messages"] = {"frame 60: no baseline picture"};
  for (Json& frame : scene["frames"]) {
    frame["metrics"] = {};
    frame["status"] = "missing";
    frame["message"] = "no baseline picture";
    for (const char* key : {"expectedPixels", "expectedImage", "differenceImage"}) frame[key] = "";
  }
  return scene;
}

/// Returns a scene whose picture has another size than the baseline, so that nothing can be compared.
Json resizedScene(Maker& make) {
  Json scene = failedScene(make, "life/resized", 2, 60, 0.2);
  Json& frame = scene["frames"][1];
  frame["expectedImage"] =
      make.keep("life/resized", "small.png", frame::encodePng(picture(160, 90, 3), {}));
  frame["message"] = "the picture is 320x180, its baseline 160x90";
  frame["differenceImage"] = "";
  frame["metrics"] = {};
  scene["messages"] = {"frame 60: the picture is 320x180, its baseline 160x90"};
  return scene;
}

constexpr const char* markup =
    "it's <script>window.hacked = 1</script><img src=x onerror=\"window.hacked = 1\"> "
    "100% #1? <!--<script> </script> {{app.js}}";

Json hostileScene(Maker& make) {
  Json scene = failedScene(make, "odd #1? 100%", 2, 60, 0.2);
  scene["name"] = scene["file"] = scene["baselineReason"] = scene["baselineDriver"] = markup;
  scene["messages"] = scene["notes"] = {markup};
  scene["frames"][1]["message"] = markup;
  scene["checks"] = {check(markup, 60, 1, 0, 2, false, markup)};
  scene["attempts"] = {{{"status", "fail"}, {"messages", {markup}}}};
  scene["tolerance"][markup] = {{"value", 1}, {"origin", markup}};
  scene["divergence"] = {
      {"frame", -12},          {"step", 0},         {"steps", 22},      {"object", markup},
      {"buffer", "positions"}, {"firstElement", 7}, {"lastElement", 7}, {"message", markup}};
  return scene;
}

Json showcase(Maker& make) {
  Json scenes = {passedScene("cloth/tablecloth"),
                 flagScene(make),
                 nondeterministicScene(make),
                 missingScene(make),
                 resizedScene(make),
                 hostileScene(make)};
  scenes.push_back(failedScene(make, "cloth/long", 90, 2, 0.6));
  scenes.push_back(passedScene("life/updated", "updated"));
  scenes.push_back(passedScene("life/glider", "xpass"));
  scenes.back()["xfail"] = "the glider turns left on this driver";
  for (Json& frame : scenes.back()["frames"]) frame["status"] = "pass";
  Json flaky = passedScene("cloth/flaky", "flaky");
  for (Json& frame : flaky["frames"]) frame["status"] = "pass";
  flaky["attempts"] = {{{"status", "fail"}, {"messages", {"frame 60: 4.1 % of the pixels differ"}}}};
  scenes.push_back(flaky);
  Json expected = failedScene(make, "cloth/knot", 2, 60, 0.2);
  expected["status"] = "xfail";
  expected["xfail"] = "self-collision is not there yet";
  scenes.push_back(expected);
  Json broken = emptyScene("life/broken", "error");
  broken["messages"] = {"scenes/life/broken.json:12:5: unknown key \"colour\"; did you mean \"color\"?"};
  broken["tolerance"] = Json::object();
  broken["profile"] = "";
  scenes.push_back(broken);
  Json tolerated = passedScene("cloth/curtain");
  tolerated["frames"][1]["pixels"] = "0";
  tolerated["frames"][1]["metrics"] = metricsOf(picture(320, 180, 0), picture(320, 180, 0.005));
  tolerated["frames"][2]["alternate"] = 2;
  scenes.push_back(tolerated);
  return scenes;
}

Json suiteOf(const Json& scenes) {
  Json counts = Json::object();
  for (const Json& scene : scenes) {
    const std::string status = scene["status"];
    counts[status] = counts.value(status, 0) + 1;
  }
  return {{"simreel", "0.1.0"},
          {"format", 4},
          {"unit", "scene"},
          {"expected", ""},
          {"environment",
           {{"driver", "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core Profile) Mesa 22.3.6"},
            {"profile", "llvmpipe"},
            {"processor", "Testium 4, family 6"},
            {"fingerprint", "5f1c09b24e7d4c38"},
            {"drawing", "0c1d2e3f40516273"},
            {"memoryPath", "texel"}}},
          {"command", "simreel test scenes --report out/report"},
          {"acceptCommand", "simreel accept out/report"},
          {"allowFlaky", true},
          {"strict", false},
          {"seconds", 83.4},
          {"notes", Json::array()},
          {"stale", Json::array()},
          {"counts", counts},
          {"scenes", scenes}};
}

int run(int count, char** arguments) {
  const std::string what = count > 2 ? arguments[2] : "";
  Maker make;
  make.folder = count > 1 ? arguments[1] : "";
  fs::create_directories(make.folder);
  Json scenes = Json::array();
  if (what == "showcase") {
    scenes = showcase(make);
  } else if (what == "bulk" && count == 4) {
    make.width = 128, make.height = 72;
    for (int i = 0; i < std::atoi(arguments[3]); ++i) {
      scenes.push_back(
          failedScene(make, fmt::format("group{}/scene{}", i % 7, i), 4, 60, 0.1 + i % 9 * 0.1));
      scenes.back()["frames"].erase(0);
    }
  } else if (what != "none") {
    fmt::print(stderr, "usage: make_report FOLDER showcase|bulk N|none\n");
    return 2;
  }
  golden::writeReportPage(make.folder, suiteOf(scenes).dump(1) + "\n");
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return run(count, arguments);
  } catch (const UserError& mistake) {
    fmt::print(stderr, "make_report: {}\n", mistake.what());
    return static_cast<int>(mistake.code());
  }
}

// Every shipped scene at 320x180, three frames: equal to the baseline where the driver's numerics are those
// it was made with, within a tolerance elsewhere. SIMREEL_UPDATE_GOLDEN=1 writes baselines; nothing else
// does.
#include "base/file.hpp"
#include "frame/sequence.hpp"
#include "golden/compare.hpp"
#include "gpu/context.hpp"
#include "sim/list.hpp"
#include "sim/numerics.hpp"

#include <cstdlib>
#include <filesystem>
#include <map>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

using namespace simreel;
namespace fs = std::filesystem;

namespace {

/// Keeps frames in memory.
class MemorySink : public frame::FrameSink {
 public:
  struct Kept {
    frame::Image image;
    std::string stateHash;
  };
  std::map<int, Kept> kept;

  bool wants(int /*frame*/) override { return true; }
  [[nodiscard]] std::optional<std::string> knownStateHash(int /*frame*/) const override {
    return std::nullopt;
  }
  void add(frame::FrameInfo info, frame::Image image) override {
    kept[info.frame] = {std::move(image), std::move(info.stateHash)};
  }
  void finish() override {}
  [[nodiscard]] double encodeSeconds() const override { return 0; }
  [[nodiscard]] std::string summary() const override { return {}; }
};

std::string frameName(int frame) {
  return fmt::format("{:06}.png", frame);
}

void writeBaseline(const fs::path& folder, const MemorySink& sink, const std::string& fingerprint) {
  fs::create_directories(folder);
  nlohmann::ordered_json json = {{"fingerprint", fingerprint},
                                 {"frames", nlohmann::ordered_json::object()}};
  for (const auto& [frame, kept] : sink.kept) {
    writeFileAtomically(folder / frameName(frame), frame::encodePng(kept.image, {}));
    json["frames"][std::to_string(frame)] = {{"pixels", frame::pixelHash(kept.image)},
                                             {"state", kept.stateHash}};
  }
  writeFileAtomically(folder / "baseline.json", json.dump(2) + "\n");
}

void compareFrame(const fs::path& folder, int frame, const MemorySink::Kept& kept,
                  const nlohmann::json& expected, bool sameNumerics) {
  INFO("frame ", frame);
  // Exact state is the same on every driver.
  CHECK(kept.stateHash == expected.at("state").get<std::string>());
  if (sameNumerics) {
    CHECK(frame::pixelHash(kept.image) == expected.at("pixels").get<std::string>());
    return;
  }
  const auto file = folder / frameName(frame);
  const std::string text = readFile(file, "baseline");
  const auto baseline =
      frame::decodeImage(std::as_bytes(std::span(text.data(), text.size())), file.string());
  REQUIRE(baseline.width == kept.image.width);
  REQUIRE(baseline.height == kept.image.height);
  // Other drivers filter textures and place edge samples differently: thin edges differ, areas do not.
  const scene::Tolerance tolerance;
  const auto metrics = golden::measure(kept.image, baseline, tolerance);
  for (const std::string& clause :
       golden::brokenBounds(metrics, tolerance, baseline.width, baseline.height))
    FAIL_CHECK(clause);
}

void checkScene(const std::string& name) {
  const fs::path root = SOURCE_FOLDER;
  setenv("SIMREEL_ASSETS", (root / "assets").c_str(), 1);  // NOLINT(concurrency-mt-unsafe): one thread
  const std::vector<scene::Override> small = {{"render.size", "[320,180]"}};
  const auto scene = scene::loadScene(root / "assets/scenes" / (name + ".json"), small, sim::kinds());
  const int last = scene.frameCount() - 1;
  MemorySink sink;
  frame::Progress silent(frame::Progress::Mode::none);
  static_cast<void>(frame::renderSequence(scene, testContext(), {0, last / 2, last}, sink, silent));
  REQUIRE(sink.kept.size() == 3);
  const auto fingerprint = sim::probeNumerics().fingerprint;
  const fs::path folder = root / "tests/golden" / name;
  // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
  if (std::getenv("SIMREEL_UPDATE_GOLDEN") != nullptr) writeBaseline(folder, sink, fingerprint);
  const auto baseline = nlohmann::json::parse(readFile(folder / "baseline.json", "baseline"));
  REQUIRE(baseline.at("frames").size() == 3);
  for (const auto& [frame, kept] : sink.kept)
    compareFrame(folder, frame, kept, baseline.at("frames").at(std::to_string(frame)),
                 baseline.at("fingerprint") == fingerprint);
}

}  // namespace

TEST_CASE("golden: every shipped scene has a baseline") {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(SOURCE_FOLDER) / "assets/scenes")) {
    if (entry.path().extension() != ".json") continue;
    ++scenes;
    CHECK_MESSAGE(
        fs::exists(fs::path(SOURCE_FOLDER) / "tests/golden" / entry.path().stem() / "baseline.json"),
        entry.path().string());
  }
  CHECK(scenes >= 3);
}

TEST_CASE("golden: flag") {
  checkScene("flag");
}
TEST_CASE("golden: curtain") {
  checkScene("curtain");
}
TEST_CASE("golden: tablecloth") {
  checkScene("tablecloth");
}

#include "golden/suite/judge.hpp"

#include "frame/image.hpp"
#include "golden/compare/compare.hpp"
#include "unit/help.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::golden;

namespace {

constexpr int width = 40, height = 30;

const Origin maker{"numerics", "drawing", "Testium 3", "llvmpipe (LLVM 15), OpenGL 4.5 Mesa 22"};

Origin otherMachine() {
  Origin origin = maker;
  origin.processor = "Testium 4";
  return origin;
}

/// Returns a grey frame in which `count` pixels are brighter by `step`.
RunFrame made(int count, int step) {
  RunFrame frame;
  frame.image = {width, height, std::vector<std::uint8_t>(4 * width * height, 128)};
  for (std::size_t i = 3; i < frame.image.bytes.size(); i += 4) frame.image.bytes[i] = 255;
  for (int i = 0; i < count; ++i)
    frame.image.bytes[static_cast<std::size_t>(4 * (i * 7 % (width * height)) + i % 3)] =
        static_cast<std::uint8_t>(128 + step);
  frame.pixels = frame::pixelHash(frame.image);
  frame.state = {{"flag.positions", "aa"}};
  return frame;
}

class Baseline {
 public:
  explicit Baseline(const Origin& origin) {
    const RunFrame frame = made(0, 0);
    Candidate candidate;
    candidate.pictures.width = width;
    candidate.pictures.height = height;
    candidate.pictures.frames[0] = {frame.pixels, origin, {}};
    candidate.png[0] = frame::encodePng(frame.image, {});
    candidate.state.frames[0] = frame.state;
    promote(folder_, "any", candidate, {});
  }
  ~Baseline() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Baseline(const Baseline&) = delete;
  Baseline& operator=(const Baseline&) = delete;
  Baseline(Baseline&&) = delete;
  Baseline& operator=(Baseline&&) = delete;

  [[nodiscard]] FrameResult judged(const RunFrame& frame, const Origin& here,
                                   const scene::Tolerance& tolerance = {},
                                   Measures measures = Measures::all) const {
    Reference reference = findReference(folder_, "llvmpipe", true, here);
    reference.tolerance = tolerance;
    return judgeFrame(frame, reference, measures).frame;
  }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("simreel-judge-" + std::to_string(::getpid()));
};

bool passes(const FrameResult& result) {
  return result.status == Status::pass;
}

}  // namespace

TEST_CASE("judge: the criteria depend on the machine that drew the baseline") {
  CHECK(requiredMatch(maker, maker) == RequiredMatch::equal);
  CHECK(requiredMatch(maker, otherMachine()) == RequiredMatch::near);
  Origin other = maker;
  other.driver = "llvmpipe (LLVM 19), OpenGL 4.5 Mesa 25";
  CHECK(requiredMatch(maker, other) == RequiredMatch::near);
  other.drawing = "others";
  CHECK(requiredMatch(maker, other) == RequiredMatch::tolerance);
  other = maker;
  other.numerics = "others";
  CHECK(requiredMatch(maker, other) == RequiredMatch::tolerance);
  // In baselines of earlier versions, drawing fingerprint and machine are unknown.
  CHECK(requiredMatch({"numerics", "", "", ""}, maker) == RequiredMatch::near);
  CHECK(requiredMatch({"others", "", "", ""}, maker) == RequiredMatch::tolerance);
  CHECK(requiredMatch({"numerics", "drawing", "", ""}, {"numerics", "drawing", "", ""}) ==
        RequiredMatch::near);
}

TEST_CASE("judge: on the baseline's own machine all bits must be equal") {
  const Baseline baseline(maker);
  CHECK(passes(baseline.judged(made(0, 0), maker)));
  const FrameResult result = baseline.judged(made(1, 1), maker);
  CHECK(result.status == Status::fail);
  CHECK(result.asked == "equal");
  simreel::test::checkHas(result.message, "1 pixels differ, by 1 at most");
}

TEST_CASE("judge: another machine with equal numerics may differ by 2 of 255 in 2% of the pixels") {
  const Baseline baseline(maker);
  const auto judged = [&](int count, int step) {
    return baseline.judged(made(count, step), otherMachine());
  };
  CHECK(passes(judged(0, 0)));
  CHECK(passes(judged(1, 1)));
  CHECK(passes(judged(1, 2)));
  CHECK(passes(judged(24, 1)));  // 24 pixels are 2% of the 1200 pixels.
  CHECK(judged(1, 1).asked == "near");
  simreel::test::checkHas(judged(1, 3).message, "differs by 3 (on another machine by 2 at most)");
  simreel::test::checkHas(judged(25, 1).message, "of the pixels differ (on another machine 2% at most)");
  // A stricter tolerance of the scene applies on every machine.
  scene::Tolerance none;
  none.maxChannelDiff = 0;
  none.maxDiffRatio = 0;
  CHECK(!passes(baseline.judged(made(1, 1), otherMachine(), none)));
  // The state must be equal on every machine.
  RunFrame moved = made(0, 0);
  moved.state["flag.positions"] = "bb";
  simreel::test::checkHas(baseline.judged(moved, otherMachine()).message,
                          "the state differs: flag.positions");
}

TEST_CASE("judge: the mean FLIP error is checked on other machines") {
  Metrics metrics;
  CHECK(brokenNearness(metrics, width, height).empty());
  metrics.flipMean = 0.0021;
  REQUIRE(brokenNearness(metrics, width, height).size() == 1);
  simreel::test::checkHas(brokenNearness(metrics, width, height).front(), "FLIP error is 0.0021");
}

TEST_CASE("judge: quick measuring skips SSIM and FLIP unless the verdict needs them") {
  const Baseline baseline(maker);
  Origin other = otherMachine();
  other.numerics = "others";
  const auto quick = [&](const Origin& here, const scene::Tolerance& tolerance) {
    return *baseline.judged(made(1200, 12), here, tolerance, Measures::quick).metrics;
  };
  const Metrics whole = *baseline.judged(made(1200, 12), maker).metrics;
  REQUIRE((whole.ssim < 1 && whole.flipMean > 0));
  for (const Origin& here : {maker, other}) {
    Metrics wanted = whole;
    wanted.ssim = wanted.flipMean = std::nullopt;
    CHECK(quick(here, {}) == wanted);
  }
  scene::Tolerance bound;
  bound.maxFlipMean = 0.5;
  CHECK(quick(other, bound) == whole);
  CHECK(quick(otherMachine(), {}) == whole);  // The quick test also compares the mean FLIP error.
}

TEST_CASE("judge: different numerics use the scene's tolerance") {
  const Baseline baseline(maker);
  Origin other = otherMachine();
  other.numerics = "others";
  CHECK(passes(baseline.judged(made(1200, 12), other)));
  CHECK(baseline.judged(made(1200, 12), other).asked == "tolerance");
  CHECK(!passes(baseline.judged(made(1200, 13), other)));
}

TEST_CASE("judge: old baselines without a machine are read") {
  const Baseline baseline({"numerics", "", "", ""});
  std::ifstream file(baseline.folder() / "any/baseline.json");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  CHECK(!simreel::test::has(text, "machine"));
  CHECK(!simreel::test::has(text, "drawing"));
  CHECK(passes(baseline.judged(made(1, 2), maker)));
  CHECK(!passes(baseline.judged(made(1, 3), maker)));
}

TEST_CASE("judge: a baseline stores the machine of each frame") {
  const Baseline baseline(maker);
  const auto read = readPictures(baseline.folder(), "any");
  REQUIRE(read);
  CHECK(read->frames.at(0).origin == maker);
}

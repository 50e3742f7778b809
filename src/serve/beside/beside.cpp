#include "serve/beside/beside.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "draw/screen/picture_probe.hpp"
#include "frame/image.hpp"
#include "gl/machine.hpp"
#include "golden/baseline/profile.hpp"
#include "golden/baseline/tolerance.hpp"
#include "golden/compare/difference_image.hpp"
#include "scene/load.hpp"
#include "serve/beside/verdict_words.hpp"
#include "sim/world/list.hpp"
#include "sim/world/survey.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::serve {

namespace {

using json = nlohmann::ordered_json;

std::string pngBytes(const frame::Image& image) {
  const auto png = frame::encodePng(image, {});
  return {reinterpret_cast<const char*>(png.data()), png.size()};
}

}  // namespace

Beside::Beside(SceneSource source, bool edit, const gl::Context& context, const sim::Numerics& numerics,
               Hub& hub)
    : source_(std::move(source)), edit_(edit), context_(context), numerics_(numerics), hub_(hub) {}

void Beside::turn(bool on) {
  on_ = on;
  verdict_.clear();
  tell();
}

void Beside::choose(SceneSource source, bool right) {
  source_ = std::move(source);
  right_ = right;
  verdict_.clear();
  tell();
}

void Beside::tell() {
  json message = verdict_.empty() ? json::object() : json::parse(verdict_);
  message["kind"] = "golden";
  message["on"] = on_;
  message["edit"] = edit_;
  message["right"] = right_;
  message["accept"] = accepted_;
  message["said"] = said_;
  hub_.tell("golden", message.dump(-1, ' ', false, json::error_handler_t::replace));
}

void Beside::look(Stage& stage) {
  if (!on_) return;
  json message = {{"frame", stage.frame()}};
  try {
    draw(stage, message);
  } catch (const UserError& error) {
    message["verdict"] = "error";
    message["words"] = error.what();
  }
  verdict_ = message.dump(-1, ' ', false, json::error_handler_t::replace);
  tell();
}

void Beside::draw(Stage& stage, json& message) {
  if (stage.testScene() == nullptr) {
    std::vector<scene::Override> all = source_.given;
    all.insert(all.end(), stage.script().edits.begin(), stage.script().edits.end());
    auto tested = std::make_unique<scene::Scene>(
        scene::loadTestScene(source_.file, all, sim::kinds(), source_.folders));
    tested->render.size = tested->test.size;
    if (tested->test.samples) tested->render.samples = *tested->test.samples;
    static_cast<void>(sim::frameMotion(*tested));
    stage.setTestScene(std::move(tested));
  }
  const scene::Scene& scene = *stage.testScene();
  const std::vector<int> frames = scene.testFrames();
  message["tested"] = frames;
  message["size"] = {scene.render.size.x, scene.render.size.y};
  const golden::Reference held = reference(scene);
  if (std::find(frames.begin(), frames.end(), stage.frame()) == frames.end()) {
    message["verdict"] = "untested";
    message["words"] = untestedWords(stage.frame(), frames, held);
    return;
  }
  const golden::RunFrame made = stage.drawTested();
  const golden::Judgement judged = golden::judgeFrame(made, held);
  message["number"] = ++pictures_;
  message["verdict"] = golden::statusName(judged.frame.status);
  message["words"] = verdictWords(judged.frame, held, made.image);
  if (const auto& metrics = judged.frame.metrics)
    message["worst"] = {{"by", metrics->worst}, {"x", metrics->worstX}, {"y", metrics->worstY}};
  hub_.offer("golden-ours.png", pngBytes(made.image));
  if (judged.frame.expectedPixels.empty() || judged.damaged) return;
  const frame::Image baseline = golden::referencePicture(held, made.frame, judged.frame.alternate);
  message["baseline"] = {baseline.width, baseline.height};
  hub_.offer("golden-baseline.png", pngBytes(baseline));
  if (baseline.width != made.image.width || baseline.height != made.image.height) return;
  message["difference"] = true;
  hub_.offer("golden-difference.png", pngBytes(golden::differenceImage(baseline, made.image)));
}

golden::Reference Beside::reference(const scene::Scene& scene) {
  const bool exact = scene.numerics == scene::Numerics::exact;
  golden::Origin here = golden::exactOrigin;
  std::string profile = golden::sharedProfile;
  if (!scene.drawsExactly()) {
    if (!driver_) {
      const gl::Machine machine = gl::machineOf(context_);
      driver_ = {numerics_.fingerprint, draw::probePictures(), machine.processor, machine.driver};
    }
    here = *driver_;
    profile = golden::ownProfile(context_.device().name);
  }
  golden::Reference held =
      golden::findReference(golden::baselineFolder(source_.file), profile, exact, here);
  held.tolerance = scene.test.tolerance;
  if (held.pictures)
    for (const auto& [field, value] : held.pictures->tolerance)
      golden::setBound(held.tolerance, field, value);
  return held;
}

void Beside::accept(std::span<const scene::Override> edits) {
  if (!edit_) fail(ExitCode::usage, "baselines are written only with simreel serve --edit");
  if (!edits.empty() || !source_.given.empty())
    fail(ExitCode::usage,
         "a baseline must show the saved scene file, but {} was changed; save the change, or undo it",
         edits.empty() ? source_.given.front().path : edits.front().path);
  if (accepting_.running()) fail(ExitCode::usage, "baselines are being written already; wait for that");
  std::vector<std::string> words = {"test", source_.file.string(), "--update", "--reason",
                                    "accepted in simreel serve"};
  for (const std::filesystem::path& folder : source_.folders)
    words.push_back("--assets=" + folder.string());
  accepting_.start(words);
  accepted_ = "running";
  said_.clear();
  tell();
}

bool Beside::hasAccepted() {
  const auto code = accepting_.ended();
  if (!code) return false;
  accepted_ = *code == 0 ? "done" : "failed";
  said_ = accepting_.output() + accepting_.messages();
  tell();
  return true;
}

scene::Override Beside::withFrame(Stage& stage, int frame) const {
  if (!edit_) fail(ExitCode::usage, "a scene's tested frames are written only with simreel serve --edit");
  const std::filesystem::path beside = scene::sidecarOf(source_.file);
  if (pathExists(beside)) {
    constexpr std::size_t byteLimit = std::size_t{16} << 20;
    const auto test = json::parse(readFile(beside, "test settings", byteLimit), nullptr, false, true);
    if (test.is_discarded() || test.contains("test"))
      fail(ExitCode::usage, "the scene's test is in {}; add {} to its \"frames\" there", beside.string(),
           frame);
  }
  std::vector<int> frames = stage.script().scene.testFrames();
  if (std::find(frames.begin(), frames.end(), frame) != frames.end())
    fail(ExitCode::usage, "frame {} is a tested frame already", frame);
  frames.push_back(frame);
  std::sort(frames.begin(), frames.end());
  return {"test.frames", fmt::format("[{}]", fmt::join(frames, ", "))};
}

std::vector<std::filesystem::path> Beside::files() const {
  const std::filesystem::path folder = golden::baselineFolder(source_.file);
  return {scene::sidecarOf(source_.file), folder / "state.json",
          folder / golden::sharedProfile / "baseline.json"};
}

}  // namespace simreel::serve

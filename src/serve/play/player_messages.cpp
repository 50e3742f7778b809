#include "base/error.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "draw/camera.hpp"
#include "gl/machine.hpp"
#include "scene/value/value_writer.hpp"
#include "serve/play/player.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::serve {

namespace {

using json = nlohmann::ordered_json;

json pointJson(const glm::vec3& point) {
  return json::array({scene::shortest(point.x), scene::shortest(point.y), scene::shortest(point.z)});
}

/// Serializes a message. Replaces invalid UTF-8, which text from files may contain.
std::string dumped(const json& message) {
  return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

json rounded(double milliseconds) {
  return std::round(milliseconds * 100) / 100;
}

}  // namespace

namespace {

/// Returns the description of one side's picture.
json pictureJson(Stage& stage, const frame::Image& image) {
  const scene::Scene& scene = stage.script().scene;
  json view;
  try {
    const double time = stage.world().time();
    const draw::View seen = draw::viewAt(scene.camera, time, scene.render.size, stage.world().drawables());
    view = {{"eye", pointJson(seen.eye)},
            {"target", pointJson(seen.target)},
            {"angle", scene::shortest(scene.camera.fieldOfView.at(time))}};
    if (seen.parallel) view["height"] = scene::shortest(scene.camera.height.at(time));
  } catch (const UserError&) {
    view = nullptr;
  }
  return {{"width", image.width},       {"height", image.height},     {"carried", stage.carried()},
          {"stepped", stage.stepped()}, {"state", stage.stateHash()}, {"view", view}};
}

/// Returns the description of one side's scene.
json sceneJson(const Stage& stage, const std::vector<std::string>& words) {
  const scene::Scene& scene = stage.script().scene;
  std::string command = "simreel render";
  for (const std::string& word : words) command += " " + inShellQuotes(word);
  json message = {{"title", scene.title},
                  {"frames", std::max(scene.frameCount(), stage.firstFrame() + 1)},
                  {"fps", scene.time.fps},
                  {"size", {scene.render.size.x, scene.render.size.y}},
                  {"samples", scene.render.samples},
                  {"numerics", scene.numerics == scene::Numerics::exact ? "exact" : "fast"},
                  {"rasterizer", scene.render.rasterizer == scene::Rasterizer::exact ? "exact" : "driver"},
                  {"staged", scene.staged},
                  {"scene", nlohmann::ordered_json::parse(stage.script().asRun)},
                  {"command", command},
                  {"checks", json::array()}};
  for (const scene::Check& check : scene.checks)
    message["checks"].push_back({{"what", check.what},
                                 {"object", check.object},
                                 {"of", check.of},
                                 {"min", check.min ? json(*check.min) : json()},
                                 {"max", check.max ? json(*check.max) : json()}});
  return message;
}

json editsJson(const std::vector<scene::Override>& edits) {
  json list = json::array();
  for (const scene::Override& edit : edits) list.push_back({edit.path, edit.value});
  return list;
}

}  // namespace

namespace {

/// Returns the series for the charts. Limits each to the number of values that a chart can show and always
/// includes the latest value.
json seriesJson(const std::vector<Series>& all) {
  constexpr std::size_t maxPoints = 240;
  json list = json::array();
  for (const Series& series : all) {
    const std::size_t stride = std::max<std::size_t>(1, (series.values.size() + maxPoints - 1) / maxPoints);
    json frames = json::array(), values = json::array();
    std::size_t at = 0;
    for (const auto& [frame, value] : series.values) {
      const bool last = at + 1 == series.values.size();
      if (at++ % stride != 0 && !last) continue;
      frames.push_back(frame);
      values.push_back(std::isfinite(value) ? json(value) : json());
    }
    list.push_back({{"object", series.object},
                    {"name", series.name},
                    {"unit", series.unit},
                    {"frames", std::move(frames)},
                    {"values", std::move(values)}});
  }
  return list;
}

}  // namespace

std::string Player::describe(const Drawn& drawn) const {
  const StageMilliseconds spent = took();
  json message = pictureJson(*stage_, drawn.image);
  message["number"] = drawn.number;
  message["frame"] = stage_->frame();
  message["type"] = drawn.draft ? "image/jpeg" : "image/png";
  message["draft"] = drawn.draft;
  message["took"] = {{"simulate", rounded(spent.simulate)},
                     {"draw", rounded(spent.draw)},
                     {"read back", rounded(spent.readBack)},
                     {"encode", rounded(encodeMs_)}};
  if (drawn.other) {
    message["beside"] = pictureJson(*other_.stage(), *drawn.other);
    message["beside"]["different"] = drawn.different ? json(*drawn.different) : json();
    message["files"] = json::array();
    for (const std::string& file : drawn.files) message["files"].push_back(file.size());
  }
  return dumped(message);
}

void Player::tellAbout() {
  const gl::Machine machine = gl::machineOf(context_);
  hub_.tell("about", dumped({{"kind", "about"},
                             {"version", version()},
                             {"file", options_.source.file.string()},
                             {"edit", options_.edit},
                             {"output", options_.output.string()},
                             {"driver", machine.driver},
                             {"processor", machine.processor},
                             {"device", context_.device().name}}));
}

void Player::tellScene() {
  json message = json::object();
  if (stage_ != nullptr) message = sceneJson(*stage_, wordsOf(false));
  message["kind"] = "scene";
  message["mistakes"] = mistakes_;
  message["edits"] = editsJson(edits_);
  message["given"] = json::array();
  for (const scene::Override& given : options_.source.given) message["given"].push_back(given.path);
  if (other_.on()) {
    json other = json::object();
    if (other_.stage() != nullptr) other = sceneJson(*other_.stage(), wordsOf(true));
    other["mistakes"] = other_.mistakes();
    other["edits"] = editsJson(other_.edits());
    other["file"] = options_.other.source.file.string();
    other["ownFile"] = other_.ownFile();
    other["difference"] = difference_;
    message["beside"] = std::move(other);
  }
  hub_.tell("scene", dumped(message));
}

/// Returns the command-line arguments that render one side: scene, options and values.
std::vector<std::string> Player::wordsOf(bool other) const {
  std::vector<std::string> words = other ? other_.options().arguments : options_.arguments;
  const Stage* stage = other ? other_.stage() : stage_.get();
  if (stage != nullptr)
    for (const scene::Override& edit : stage->script().edits)
      words.insert(words.end(), {"-D", edit.path + "=" + edit.value});
  return words;
}

void Player::sendStatus() {
  double rate = 0;
  if (times_.size() > 1 && secondsSince(times_.back()) < 1)
    rate = static_cast<double>(times_.size() - 1) /
           std::max(1e-3, std::chrono::duration<double>(times_.back() - times_.front()).count());
  json message = {{"kind", "status"},     {"playing", playing_},  {"loop", loop_},
                  {"target", target_},    {"moving", isMoving()}, {"failed", failed_},
                  {"rate", rounded(rate)}};
  if (stage_ != nullptr) {
    const KeptStates& kept = stage_->kept();
    const Stage* other = other_.stage();
    message["frame"] = other == nullptr || stage_->frame() != target_ ? stage_->frame() : other->frame();
    message["kept"] = {{"count", kept.frames().size()},
                       {"every", kept.interval()},
                       {"last", kept.frames().empty() ? -1 : kept.frames().back()},
                       {"bytes", kept.bytes()},
                       {"most", options_.memory}};
  }
  hub_.tell("status", dumped(message));
}

void Player::sendSeries() {
  statusSentAt_ = Clock::now();
  if (stage_ == nullptr) return;
  json message = {{"kind", "series"}, {"series", seriesJson(stage_->series())}};
  if (other_.stage() != nullptr) message["beside"] = seriesJson(other_.stage()->series());
  hub_.tell("series", dumped(message));
}

}  // namespace simreel::serve

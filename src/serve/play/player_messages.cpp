#include "base/error.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "draw/camera.hpp"
#include "gl/machine.hpp"
#include "scene/value_writer.hpp"
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

/// Text from files and messages may hold anything.
std::string dumped(const json& message) {
  return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

json rounded(double milliseconds) {
  return std::round(milliseconds * 100) / 100;
}

}  // namespace

std::string Player::describe(const frame::Image& image, std::uint64_t number, bool draft) const {
  const scene::Scene& scene = stage_->script().scene;
  const StageMilliseconds& took = stage_->took();
  json view;
  try {
    const double time = stage_->world().time();
    const draw::View seen =
        draw::viewAt(scene.camera, time, scene.render.size, stage_->world().drawables());
    view = {{"eye", pointJson(seen.eye)},
            {"target", pointJson(seen.target)},
            {"angle", scene::shortest(scene.camera.fieldOfView.at(time))}};
  } catch (const UserError&) {
    view = nullptr;
  }
  return dumped({{"number", number},
                 {"frame", stage_->frame()},
                 {"type", draft ? "image/jpeg" : "image/png"},
                 {"width", image.width},
                 {"height", image.height},
                 {"draft", draft},
                 {"carried", stage_->carried()},
                 {"state", stage_->stateHash()},
                 {"view", view},
                 {"took",
                  {{"simulate", rounded(took.simulate)},
                   {"draw", rounded(took.draw)},
                   {"read back", rounded(took.readBack)},
                   {"encode", rounded(encodeMs_)}}}});
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
  json message = {{"kind", "scene"}, {"mistakes", mistakes_}, {"edits", json::array()}};
  for (const scene::Override& edit : edits_) message["edits"].push_back({edit.path, edit.value});
  message["given"] = json::array();
  for (const scene::Override& given : options_.source.given) message["given"].push_back(given.path);
  if (stage_ != nullptr) {
    const scene::Scene& scene = stage_->script().scene;
    message["title"] = scene.title;
    message["frames"] = scene.frameCount();
    message["fps"] = scene.time.fps;
    message["size"] = {scene.render.size.x, scene.render.size.y};
    message["samples"] = scene.render.samples;
    message["numerics"] = scene.numerics == scene::Numerics::exact ? "exact" : "fast";
    message["rasterizer"] = scene.render.rasterizer == scene::Rasterizer::exact ? "exact" : "driver";
    message["staged"] = scene.staged;
    message["scene"] = nlohmann::ordered_json::parse(stage_->script().asRun);
    message["command"] = commandLine();
    message["checks"] = json::array();
    for (const scene::Check& check : scene.checks)
      message["checks"].push_back({{"what", check.what},
                                   {"object", check.object},
                                   {"of", check.of},
                                   {"min", check.min ? json(*check.min) : json()},
                                   {"max", check.max ? json(*check.max) : json()}});
  }
  hub_.tell("scene", dumped(message));
}

std::string Player::commandLine() const {
  std::string line = "simreel render";
  for (const std::string& word : options_.arguments) line += " " + inShellQuotes(word);
  for (const scene::Override& edit : edits_) line += " -D " + inShellQuotes(edit.path + "=" + edit.value);
  return line;
}

void Player::tellStatus() {
  double rate = 0;
  if (times_.size() > 1 && secondsSince(times_.back()) < 1)
    rate = static_cast<double>(times_.size() - 1) /
           std::max(1e-3, std::chrono::duration<double>(times_.back() - times_.front()).count());
  json message = {{"kind", "status"},     {"playing", playing_},  {"loop", loop_},
                  {"target", target_},    {"moving", isMoving()}, {"failed", failed_},
                  {"rate", rounded(rate)}};
  if (stage_ != nullptr) {
    const KeptStates& kept = stage_->kept();
    message["frame"] = stage_->frame();
    message["kept"] = {{"count", kept.frames().size()},
                       {"every", kept.interval()},
                       {"last", kept.frames().empty() ? -1 : kept.frames().back()},
                       {"bytes", kept.bytes()},
                       {"most", options_.memory}};
  }
  hub_.tell("status", dumped(message));
}

void Player::tellSeries() {
  told_ = Clock::now();
  if (stage_ == nullptr) return;
  constexpr std::size_t mostPoints = 240;
  json all = json::array();
  for (const Series& series : stage_->series()) {
    const std::size_t stride =
        std::max<std::size_t>(1, (series.values.size() + mostPoints - 1) / mostPoints);
    json frames = json::array(), values = json::array();
    std::size_t at = 0;
    for (const auto& [frame, value] : series.values) {
      const bool last = at + 1 == series.values.size();
      if (at++ % stride != 0 && !last) continue;
      frames.push_back(frame);
      values.push_back(std::isfinite(value) ? json(value) : json());
    }
    all.push_back({{"object", series.object},
                   {"name", series.name},
                   {"unit", series.unit},
                   {"frames", std::move(frames)},
                   {"values", std::move(values)}});
  }
  hub_.tell("series", dumped({{"kind", "series"}, {"series", std::move(all)}}));
}

}  // namespace simreel::serve

#include "serve/beside/counterpart.hpp"

#include "base/error.hpp"
#include "scene/scene_source.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>

namespace simreel::serve {

void Counterpart::turn(bool on) {
  on_ = on;
  if (on) return;
  stage_ = nullptr;
  mistakes_.clear();
}

bool Counterpart::hasOwnView() const {
  constexpr std::array<std::string_view, 5> views = {"camera.position", "camera.target", "camera.orbit",
                                                     "camera.follow", "camera.track"};
  return std::any_of(options_.edits.begin(), options_.edits.end(), [&](const scene::Override& edit) {
    return edit.path == "camera" || std::any_of(views.begin(), views.end(), [&](std::string_view view) {
             return edit.path.starts_with(view);
           });
  });
}

void Counterpart::readFile() {
  if (!options_.ownFile) return;
  unreadable_.clear();
  try {
    text_ = scene::readSceneSource(options_.source.file, sim::kinds()).first;
  } catch (const UserError& error) {
    unreadable_ = error.what();
  }
}

std::shared_ptr<Script> Counterpart::scriptBeside(const Stage& scene) const {
  std::vector<scene::Override> edits;
  if (!options_.ownFile) edits = scene.script().edits;
  for (const scene::Override& edit : options_.edits) edits = withEdit(edits, edit);
  return readScript(options_.source, options_.ownFile ? text_ : scene.script().text, std::move(edits));
}

bool Counterpart::isBetter(const Stage& scene) const {
  if (!on_ || !unread_ || !unreadable_.empty()) return false;
  try {
    return scriptBeside(scene) != nullptr;
  } catch (const UserError&) {
    return false;
  }
}

bool Counterpart::update(const Stage& scene, const sim::Numerics& numerics, std::size_t memory, bool moving,
                         int frame) {
  if (!on_) return false;
  if (options_.ownFile && text_.empty()) readFile();
  mistakes_ = unreadable_;
  if (!mistakes_.empty()) return false;
  unread_ = true;
  try {
    auto script = scriptBeside(scene);
    unread_ = false;
    sim::requireExact(script->scene, numerics);
    placeCamera(*script, stage_ == nullptr ? nullptr : &stage_->script(), moving);
    if (stage_ != nullptr) return stage_->become(std::move(script), moving);
    stage_ =
        std::make_unique<Stage>(std::move(script), memory, options_.ownFile ? nullptr : scene.origin());
    stage_->startLike(scene, frame);
  } catch (const UserError& error) {
    mistakes_ = error.what();
  }
  return false;
}

std::size_t differingPixels(const frame::Image& a, const frame::Image& b) {
  constexpr std::size_t each = 4;
  const std::size_t compared = a.alpha || b.alpha ? each : each - 1;
  std::size_t count = 0;
  for (std::size_t at = 0; at + each <= std::min(a.bytes.size(), b.bytes.size()); at += each)
    count += std::memcmp(a.bytes.data() + at, b.bytes.data() + at, compared) != 0 ? 1 : 0;
  return count;
}

}  // namespace simreel::serve

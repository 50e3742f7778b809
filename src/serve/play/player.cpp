#include "serve/play/player.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "frame/interrupt.hpp"
#include "scene/scene_source.hpp"
#include "serve/play/jpeg.hpp"
#include "sim/core/numerics.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace simreel::serve {

namespace {

constexpr double secondsBetweenLooks = 0.1;  ///< at the files
constexpr double secondsToRest = 0.25;       ///< after the last drag, before the whole picture is drawn
constexpr double sliceSeconds = 0.04;        ///< of stepping, before requests are heard again
constexpr double mostMilliseconds = 85;      ///< of a picture while things move
constexpr double mostToMeasure = 6;          ///< ms of a picture while things move
constexpr int jpegQuality = 87;

}  // namespace

Player::Player(PlayerOptions options, const gl::Context& context, Hub& hub)
    : options_(std::move(options)),
      context_(context),
      hub_(hub),
      numerics_(sim::probeNumerics()),
      beside_(options_.source, options_.edit, context, numerics_, hub) {
  tellAbout();
  readFile();
  if (show(text_, {}, false)) return;
  watch();
}

Player::~Player() = default;

void Player::run() {
  while (!hub_.stopping() && frame::interruptSignal() == 0) turn();
}

void Player::turn() {
  for (const Request& request : hub_.take(secondsToWait())) handle(request);
  if (secondsSince(looked_) >= secondsBetweenLooks) {
    looked_ = Clock::now();
    if (files_.changed()) {
      try {
        readFile();
        show(text_, edits_, false);
      } catch (const UserError& error) {
        report(error.what());
      }
    }
  }
  lookAtRender();
  if (beside_.hasAccepted()) lookBeside();
  if (stage_ == nullptr || failed_ || hub_.viewers() == 0) return;
  try {
    work();
    context_.check();
  } catch (const UserError& error) {
    failed_ = true;
    playing_ = false;
    report(error.what());
    tellStatus();
  }
}

void Player::readFile() {
  text_ = scene::readSceneSource(options_.source.file, sim::kinds()).first;
}

void Player::report(const std::string& text) {
  mistakes_ = text;
  tellScene();
}

bool Player::show(const std::string& text, std::vector<scene::Override> edits, bool moving) {
  std::shared_ptr<Script> script;
  try {
    script = readScript(options_.source, text, std::move(edits));
    sim::requireExact(script->scene, numerics_);
    adopt(std::move(script), moving);
  } catch (const UserError& error) {
    report(error.what());
    return false;
  }
  edits_ = stage_->script().edits;
  mistakes_.clear();
  failed_ = false;
  shown_ = rest_ = false;
  target_ = std::min(target_, lastFrame());
  watch();
  tellScene();
  return true;
}

/// What may stay, stays: renderers, the world, its states.
void Player::adopt(std::shared_ptr<Script> script, bool moving) {
  if (stage_ == nullptr) return replay(std::move(script));
  switch (changeBetween(stage_->script(), *script)) {
    case Change::nothing:
    case Change::look:
      return stage_->takeLookOf(*script);
    case Change::drawing:
      return stage_->drawAs(std::move(script));
    case Change::dress:
      return stage_->dressAs(std::move(script));
    case Change::simulation:
      // While a slider moves there is no time to begin at the start: what is there goes on with its values.
      // What they do shows as it goes on; let go of, it is made good at the frame where it was.
      if (moving && stage_->carryOverTo(script)) {
        if (!held_) held_ = target_;
        if (target_ < lastFrame()) ++target_;
        return;
      }
      return replay(std::move(script));
  }
}

void Player::replay(std::shared_ptr<Script> script) {
  stage_ = std::make_unique<Stage>(std::move(script), options_.memory);
  costs_ = {};
  if (held_) target_ = *held_;
  held_.reset();
}

void Player::watch() {
  std::vector<std::filesystem::path> files = {options_.source.file};
  if (stage_ != nullptr) {
    const auto& named = stage_->script().scene.files;
    files.insert(files.end(), named.begin(), named.end());
  }
  for (const std::filesystem::path& file : beside_.files()) files.push_back(file);
  files_.watch(files);
}

int Player::lastFrame() const {
  return stage_ == nullptr ? 0 : stage_->script().scene.frameCount() - 1;
}

bool Player::isMoving() const {
  return playing_ || secondsSince(moved_) < secondsToRest;
}

double Player::secondsToWait() const {
  if (stage_ == nullptr || failed_ || hub_.viewers() == 0) return secondsBetweenLooks;
  if (stage_->frame() != target_ || !shown_) return 0;
  if (playing_) {
    const double left = -secondsSince(due_);
    return std::clamp(left, 0.0, secondsBetweenLooks);
  }
  return isMoving() ? 0.02 : rest_ && !stage_->carried() ? secondsBetweenLooks : 0;
}

void Player::work() {
  // What came out of other values is made good as soon as nobody moves anything.
  if (stage_->carried() && !isMoving()) {
    replay(readScript(options_.source, text_, edits_));
    shown_ = rest_ = false;
  }
  const auto begun = Clock::now();
  bool there = false;
  while (!(there = stage_->approach(target_)) && secondsSince(begun) < sliceSeconds)
    if (frame::interruptSignal() != 0) return;
  if (!there) {
    if (secondsSince(told_) > 0.1) tellStatus();
    return;
  }
  if (playing_ && shown_) {
    if (secondsSince(due_) < 0) return;
    return goOn();
  }
  if (!shown_) return drawPicture(isMoving());
  if (!rest_ && !isMoving()) drawPicture(false);
}

/// To the next frame, at the pace of the scene where that can be kept.
void Player::goOn() {
  const auto pace = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(1.0 / stage_->script().scene.time.fps));
  due_ = std::max(due_ + pace, Clock::now() - pace);
  if (target_ >= lastFrame()) {
    if (!loop_) {
      playing_ = false;
      rest_ = false;
      return tellStatus();
    }
    target_ = 0;
  } else {
    ++target_;
  }
  shown_ = rest_ = false;
}

void Player::drawPicture(bool draft) {
  const std::size_t level = draft ? level_ : 0;
  const frame::Image image = stage_->draw(level);
  const auto drawn = Clock::now();
  Picture picture;
  picture.number = ++pictures_;
  std::string bytes;
  if (draft) {
    bytes = encodeJpeg(image, jpegQuality);
  } else {
    const auto png = frame::encodePng(image, {});
    bytes.assign(reinterpret_cast<const char*>(png.data()), png.size());
  }
  encodeMs_ = 1000 * secondsSince(drawn);
  if (draft) {
    const StageMilliseconds& took = stage_->took();
    adaptDetail(took.draw + took.readBack + encodeMs_);
  }
  if (!draft || measureMs_ < mostToMeasure) {
    const auto begun = Clock::now();
    stage_->measure();
    measureMs_ = 1000 * secondsSince(begun);
  }
  times_.push_back(Clock::now());
  while (times_.size() > 20) times_.pop_front();
  // Whoever drags has had no time yet to drag on.
  if (draft && !playing_) moved_ = Clock::now();
  shown_ = true;
  rest_ = !draft;
  picture.message = describe(image, picture.number, draft) + "\n" + bytes;
  hub_.show(std::move(picture));
  tellStatus();
  if (!draft || secondsSince(told_) > 0.25) tellSeries();
  lookBeside();
}

/// Where the whole picture stands, its baseline may stand beside it.
void Player::lookBeside() {
  if (rest_ && stage_ != nullptr && stage_->frame() == target_ && !stage_->carried()) beside_.look(*stage_);
}

/// The finest level whose pictures come in time; where none do, the finest of those that cost hardly more
/// than the cheapest: what does not come from pixels gets no less with fewer of them.
void Player::adaptDetail(double milliseconds) {
  if (fresh_ != level_) {
    fresh_ = level_;
    return;
  }
  constexpr double newest = 0.4, hardlyMore = 1.25, sure = 0.8, leastForPicture = 20;
  double& known = costs_[level_];
  known = known > 0 ? (1 - newest) * known + newest * milliseconds : milliseconds;
  const double simulated = playing_ ? stage_->took().simulate : 0;
  const double budget = std::max(leastForPicture, mostMilliseconds - simulated);
  const auto pixels = [&](std::size_t level) {
    const DetailLevel& detail = detailLevels[level];
    const int samples = detail.samples > 0 ? detail.samples : stage_->script().scene.render.samples;
    return static_cast<double>(detail.scale * detail.scale * static_cast<float>(samples));
  };
  const auto cost = [&](std::size_t level) {
    return costs_[level] > 0 ? costs_[level] : costs_[level_] * pixels(level) / pixels(level_);
  };
  double least = cost(0);
  for (std::size_t level = 1; level < detailLevels.size(); ++level) least = std::min(least, cost(level));
  const double most = std::max(budget, hardlyMore * least);
  std::size_t best = level_;
  for (std::size_t level = detailLevels.size(); level-- > 0;)
    if (cost(level) <= (level < level_ ? sure : 1.0) * most) best = level;
  // One level at a time: what is not known yet is a guess.
  if (best > level_) ++level_;
  quick_ = best < level_ ? quick_ + 1 : 0;
  constexpr int picturesToBelieve = 5;
  if (quick_ < picturesToBelieve) return;
  quick_ = 0;
  --level_;
}

}  // namespace simreel::serve

#include "serve/play/player.hpp"

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/log.hpp"
#include "frame/interrupt.hpp"
#include "scene/as_run.hpp"
#include "scene/scene_source.hpp"
#include "sim/core/numerics.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace simreel::serve {

namespace {

constexpr double secondsBetweenLooks = 0.1;  ///< time (s) between checks of the files
/// Min and max time (s) without a drag request before the full picture is drawn.
constexpr double minRestSeconds = 0.25;
constexpr double maxRestSeconds = 2;
constexpr double secondsToReread = 1;  ///< time (s) between attempts to read missing files
constexpr double sliceSeconds = 0.04;  ///< max time (s) of simulation before requests are handled again

}  // namespace

Player::Player(PlayerOptions options, const gl::Context& context, Hub& hub)
    : options_(std::move(options)),
      context_(context),
      hub_(hub),
      numerics_(sim::probeNumerics()),
      beside_(options_.source, options_.edit, context, numerics_, hub),
      other_(options_.other) {
  tellAbout();
  readFile();
  if (!options_.from.empty()) from_ = frame::Checkpoint::load(options_.from);
  // A user without a page open sees in the terminal why there is no picture of a side.
  if (load(text_, {}, false)) {
    warnOfOther();
    return;
  }
  warnLinesOnce(mistakes_);
  watch();
}

/// Writes the mistakes of the right side to the terminal. Its own values came from --beside.
void Player::warnOfOther() {
  std::string text = other_.mistakes();
  if (text.empty()) return;
  for (const scene::Override& edit : other_.edits()) {
    const std::string mark = "-D " + edit.path + "=";
    if (const std::size_t at = text.find(mark); at != std::string::npos) text.replace(at, 2, "--beside");
  }
  warnLinesOnce(text);
}

Player::~Player() = default;

void Player::run() {
  while (!hub_.stopping() && frame::interruptSignal() == 0) turn();
}

void Player::turn() {
  for (const Request& request : hub_.waitForRequests(secondsToWait())) handle(request);
  if (secondsSince(filesCheckedAt_) >= secondsBetweenLooks) {
    filesCheckedAt_ = Clock::now();
    if (files_.changed()) {
      showFiles();
    } else if (secondsSince(reread_) >= secondsToReread) {
      tryAgain();
    }
  }
  lookAtRender();
  if (beside_.hasAccepted()) compareWithBaseline();
  if (stage_ == nullptr || failed_ || hub_.viewers() == 0) return;
  try {
    work();
    context_.check();
  } catch (const UserError& error) {
    failed_ = true;
    playing_ = false;
    report(error.what());
    sendStatus();
  }
}

/// Reads all files again and shows the scenes.
void Player::showFiles() {
  try {
    readFile();
    other_.readFile();
    readOrigin();
    load(text_, edits_, false);
  } catch (const UserError& error) {
    report(error.what());
  }
}

/// Checks whether a missing file that a scene names exists now, because missing files cannot be watched.
void Player::tryAgain() {
  reread_ = Clock::now();
  if (!unread_) {
    if (stage_ != nullptr && other_.isBetter(*stage_)) showFiles();
    return;
  }
  try {
    static_cast<void>(readScript(options_.source, text_, edits_));
  } catch (const UserError&) {
    return;
  }
  showFiles();
}

void Player::readFile() {
  text_ = scene::readSceneSource(options_.source.file, sim::kinds()).first;
}

void Player::readOrigin() {
  if (!from_) return;
  frame::Checkpoint again = frame::Checkpoint::load(options_.from);
  if (again.frame() == from_->frame() && again.stateHash() == from_->stateHash()) return;
  from_ = std::move(again);
  info("checkpoint {} has changed: the run begins at frame {}", options_.from.string(), from_->frame());
  if (stage_ == nullptr) return;
  const auto origin = std::make_shared<const frame::WorldState>(from_->state());
  stage_->beginAt(origin);
  if (other_.stage() != nullptr && !other_.ownFile()) other_.stage()->beginAt(origin);
  target_ = stage_->firstFrame();
  playing_ = false;
}

std::unique_ptr<Stage> Player::firstStage(std::shared_ptr<Script> script) const {
  if (!from_) return std::make_unique<Stage>(std::move(script), memoryOfEach());
  frame::RunInfo run;
  run.simulation = hashHex(scene::simulationHash(script->asRun) + script->scene.filesHash);
  run.fingerprint = numerics_.fingerprint;
  if (const auto difference = from_->mismatch(run))
    fail(ExitCode::usage, "cannot begin at checkpoint {}: {}", options_.from.string(), *difference);
  return std::make_unique<Stage>(std::move(script), memoryOfEach(),
                                 std::make_shared<const frame::WorldState>(from_->state()));
}

void Player::report(const std::string& text) {
  mistakes_ = text;
  tellScene();
}

bool Player::load(const std::string& text, std::vector<scene::Override> edits, bool moving) {
  bool carries = false;
  unread_ = true;
  try {
    auto script = readScript(options_.source, text, std::move(edits));
    unread_ = false;
    sim::requireExact(script->scene, numerics_);
    placeCamera(*script, stage_ == nullptr ? nullptr : &stage_->script(), moving);
    if (stage_ == nullptr)
      stage_ = firstStage(std::move(script));
    else
      carries = stage_->become(std::move(script), moving);
  } catch (const UserError& error) {
    report(error.what());
    return false;
  }
  edits_ = stage_->script().edits;
  mistakes_.clear();
  if (from_ && !stage_->origin())
    mistakes_ = fmt::format(
        "the state of checkpoint {} does not fit the scene any more; the page shows the run from the "
        "scene's start",
        options_.from.string());
  showOther(moving, carries);
  return true;
}

void Player::showOther(bool moving, bool carries) {
  if (stage_ == nullptr) return;
  stage_->allow(memoryOfEach());
  carries = other_.update(*stage_, numerics_, memoryOfEach(), moving, target_) || carries;
  adjustTarget(carries);
  failed_ = false;
  pictureUpToDate_ = fullPictureShown_ = false;
  target_ = std::clamp(target_, firstFrame(), lastFrame());
  watch();
  tellScene();
}

/// Adjusts the target frame to states that are carried over. While a slider is dragged, there is no time to
/// simulate from the start. The current state therefore continues with the new values, and the frames
/// advance to show their effect. After the drag, the target is the frame at which the drag began, and the
/// state of this frame is simulated from the start.
void Player::adjustTarget(bool carries) {
  if (carries) {
    if (!frameBeforeDrag_) frameBeforeDrag_ = target_;
    if (target_ < lastFrame()) ++target_;
  } else if (!isCarried()) {
    if (frameBeforeDrag_) target_ = *frameBeforeDrag_;
    frameBeforeDrag_.reset();
  }
}

void Player::resimulate() {
  stage_->resimulate();
  if (other_.stage() != nullptr) other_.stage()->resimulate();
  adjustTarget(false);
  pictureUpToDate_ = fullPictureShown_ = false;
}

void Player::watch() {
  std::vector<std::filesystem::path> files = {options_.source.file};
  if (!options_.from.empty()) files.push_back(options_.from);
  if (stage_ != nullptr) {
    const auto& named = stage_->script().scene.files;
    files.insert(files.end(), named.begin(), named.end());
  }
  if (other_.on() && other_.ownFile()) files.push_back(options_.other.source.file);
  if (other_.stage() != nullptr) {
    const auto& named = other_.stage()->script().scene.files;
    files.insert(files.end(), named.begin(), named.end());
  }
  for (const std::filesystem::path& file : beside_.files()) files.push_back(file);
  files_.watch(files);
}

/// Returns the last frame that exists on both sides.
int Player::lastFrame() const {
  if (stage_ == nullptr) return 0;
  const int last = std::max(stage_->script().scene.frameCount() - 1, firstFrame());
  return other_.stage() == nullptr ? last : std::min(last, other_.stage()->script().scene.frameCount() - 1);
}

bool Player::isAtTarget() const {
  return stage_->frame() == target_ && (other_.stage() == nullptr || other_.stage()->frame() == target_);
}

bool Player::isCarried() const {
  return stage_->carried() || other_.carried();
}

/// Moves both sides towards the target frame. Neither side is shown until both have reached the frame.
/// Returns true if both have reached it.
bool Player::approach() {
  const bool reached = stage_->approach(target_);
  return (other_.stage() == nullptr || other_.stage()->approach(target_)) && reached;
}

StageMilliseconds Player::took() const {
  StageMilliseconds all = stage_->took();
  if (other_.stage() == nullptr) return all;
  const StageMilliseconds& more = other_.stage()->took();
  return {all.simulate + more.simulate, all.draw + more.draw, all.readBack + more.readBack};
}

std::size_t Player::memoryOfEach() const {
  return other_.on() ? options_.memory / 2 : options_.memory;
}

bool Player::isMoving() const {
  if (playing_) return true;
  return restSeconds_ > 0 && (!pictureUpToDate_ || secondsSince(moved_) < restSeconds_);
}

/// Records a drag request. On a slow connection or a busy machine, drag requests arrive at long intervals.
/// The wait before the full picture is drawn grows with the interval, because a full picture during a drag
/// would make the drag even slower.
void Player::recordDrag() {
  const double pause = secondsSince(moved_);
  restSeconds_ = restSeconds_ > 0 && pause < maxRestSeconds
                     ? std::clamp(2 * pause, minRestSeconds, maxRestSeconds)
                     : minRestSeconds;
  moved_ = Clock::now();
}

void Player::letGo() {
  restSeconds_ = 0;
}

double Player::secondsToWait() const {
  if (stage_ == nullptr || failed_ || hub_.viewers() == 0) return secondsBetweenLooks;
  if (!isAtTarget() || !pictureUpToDate_) return 0;
  if (playing_) {
    const double left = -secondsSince(due_);
    return std::clamp(left, 0.0, secondsBetweenLooks);
  }
  return isMoving() ? 0.02 : fullPictureShown_ && !isCarried() ? secondsBetweenLooks : 0;
}

void Player::work() {
  // States carried over from other values are replaced when nothing moves.
  if (isCarried() && !isMoving()) resimulate();
  const auto begun = Clock::now();
  bool reached = false;
  while (!(reached = approach()) && secondsSince(begun) < sliceSeconds)
    if (frame::interruptSignal() != 0) return;
  if (!reached) {
    if (secondsSince(statusSentAt_) > 0.1) sendStatus();
    return;
  }
  if (playing_ && pictureUpToDate_) {
    if (secondsSince(due_) < 0) return;
    return nextFrame();
  }
  if (!pictureUpToDate_) return drawPicture(isMoving());
  if (!fullPictureShown_ && !isMoving()) drawPicture(false);
}

/// Advances to the next frame, if possible at the scene's frame rate.
void Player::nextFrame() {
  const auto pace = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(1.0 / stage_->script().scene.time.fps));
  due_ = std::max(due_ + pace, Clock::now() - pace);
  if (target_ >= lastFrame()) {
    if (!loop_) {
      playing_ = false;
      fullPictureShown_ = false;
      return sendStatus();
    }
    target_ = firstFrame();
  } else {
    ++target_;
  }
  pictureUpToDate_ = fullPictureShown_ = false;
}

}  // namespace simreel::serve

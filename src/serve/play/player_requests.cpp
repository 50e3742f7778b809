#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"
#include "draw/camera.hpp"
#include "scene/value/value_writer.hpp"
#include "serve/play/player.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::serve {

namespace {

constexpr JsonLimits requestLimits = {.depth = 20, .containers = 20'000, .comments = false};

std::string readFileOf(const std::string& picture) {
  try {
    return simreel::readFile(picture, "picture");
  } catch (const UserError&) {
    return {};  // The file has been removed.
  }
}

bool isSet(const JsonValue& request, const char* name) {
  const auto found = request.find(name);
  return found && found->boolean();
}

}  // namespace

void Player::handle(const Request& request) {
  try {
    const nlohmann::json json = parseStrictJson(request.text, requestLimits);
    if (hub_.editor() != request.viewer && !json.contains("asks")) {
      hub_.answer(
          request.viewer,
          R"({"kind":"refused","text":"another viewer edits this scene; press Take over to edit it here"})");
      return;
    }
    if (json.contains("asks"))
      pick(request.viewer, json);
    else
      obey(json);
  } catch (const JsonError& error) {
    hub_.answer(request.viewer, nlohmann::json{{"kind", "refused"}, {"text", error.what()}}.dump());
  } catch (const UserError& error) {
    hub_.answer(request.viewer, nlohmann::json{{"kind", "refused"}, {"text", error.what()}}.dump());
    tellScene();
  } catch (const std::exception&) {
    hub_.answer(request.viewer, R"({"kind":"refused","text":"invalid request"})");
  }
}

void Player::obey(const Json& json) {
  const JsonValue request(json);
  const std::string what = request.at("do").text();
  if (what == "play") {
    playing_ = stage_ != nullptr && lastFrame() > 0;
    due_ = Clock::now();
    if (target_ >= lastFrame() && !loop_) target_ = firstFrame();
    fullPictureShown_ = false;
  } else if (what == "pause") {
    playing_ = false;
    if (stage_ != nullptr) target_ = std::max(firstFrame(), stage_->frame());
  } else if (what == "loop") {
    loop_ = request.at("on").boolean();
  } else if (what == "seek") {
    seek(json);
  } else if (what == "camera") {
    moveCamera(json);
  } else if (what == "set") {
    setValue(json);
  } else if (what == "forget") {
    forget(json);
  } else if (what == "paint") {
    paint(json);
  } else if (what == "render") {
    renderIt(json);
  } else if (what == "compare") {
    compare(json);
  } else if (what == "beside") {
    setBeside(json);
  } else if (what == "accept") {
    if (stage_ != nullptr) beside_.accept(compared().script().edits);
  } else if (what == "testThis") {
    testThisFrame();
  } else {
    request.at("do").wrong("is an unknown command");
  }
  sendStatus();
}

void Player::seek(const Json& json) {
  const JsonValue request(json);
  // The step is clamped before it is added, so that the sum cannot overflow.
  const int wanted = request.find("by")
                         ? target_ + std::clamp(request.at("by").integer(), -lastFrame(), lastFrame())
                         : request.at("frame").integer();
  const int frame = std::clamp(wanted, firstFrame(), lastFrame());
  playing_ = false;
  failed_ = false;
  if (isSet(request, "moving"))
    recordDrag();
  else
    letGo();
  frameBeforeDrag_.reset();
  if (frame == target_) return;
  target_ = frame;
  pictureUpToDate_ = fullPictureShown_ = false;
}

namespace {

nlohmann::json pointOf(const JsonValue& value) {
  if (value.size() != 3) value.wrong("must be three numbers");
  nlohmann::json point = nlohmann::json::array();
  for (std::size_t i = 0; i < 3; ++i) {
    static_cast<void>(value.at(i).number());
    point.push_back(value.at(i).json());  // json() keeps the number as it is written in the request.
  }
  return point;
}

/// True if the camera has a constant position and a constant target, and nothing else moves it.
bool isPlain(const nlohmann::json& camera) {
  for (const char* other : {"follow", "track", "orbit", "gltf", "damping"})
    if (camera.contains(other)) return false;
  for (const char* point : {"position", "target"})
    if (camera.contains(point) && !camera.at(point).is_array()) return false;
  return true;
}

/// Camera pose set with the mouse: position, target and, for an orthographic camera, the height of the view
/// in metres.
struct Placed {
  nlohmann::json position, target;
  std::optional<double> height = {};
  bool operator==(const Placed&) const = default;
};

Placed placedBy(const JsonValue& view) {
  Placed placed{pointOf(view.at("position")), pointOf(view.at("target"))};
  if (const auto height = view.find("height")) placed.height = height->number();
  return placed;
}

/// Returns the overrides that set the pose `placed` for a scene's camera at the current frame.
std::vector<scene::Override> cameraChanges(const Stage& stage, const Placed& placed) {
  const auto& [position, target, asked] = placed;
  const scene::Scene& shown = stage.script().scene;
  const nlohmann::json scene = parseStrictJson(stage.script().asRun);
  nlohmann::json camera = scene.contains("camera") ? scene.at("camera") : nlohmann::json::object();
  const double seconds = stage.frame() / shown.time.fps;
  const bool flat = shown.camera.projection == scene::Projection::orthographic;
  const std::string angle = fmt::format("{}", shown.camera.fieldOfView.at(seconds));
  std::string height = fmt::format("{}", shown.camera.height.at(seconds));
  if (asked) height = scene::shortest(static_cast<float>(*asked)).dump();
  if (!isPlain(camera)) {
    if (shown.camera.gltf && !flat && !shown.camera.hasAngle)
      camera["fieldOfView"] = parseStrictJson(angle);
    if (flat) camera["projection"] = "orthographic";
    if (flat) camera["height"] = parseStrictJson(height);
    for (const char* other : {"follow", "track", "orbit", "gltf", "damping"}) camera.erase(other);
    camera["position"] = position;
    camera["target"] = target;
    return {{"camera", camera.dump()}};
  }
  std::vector<scene::Override> changes = {{"camera.position", position.dump()},
                                          {"camera.target", target.dump()}};
  // A camera that the scene does not describe may have an angle of view other than the default, so the
  // angle is written as well.
  if (flat && (asked || !shown.camera.hasHeight)) changes.push_back({"camera.height", height});
  if (!flat && !shown.camera.hasAngle) changes.push_back({"camera.fieldOfView", angle});
  return changes;
}

std::vector<scene::Override> withEdits(std::vector<scene::Override> edits,
                                       const std::vector<scene::Override>& changes) {
  for (const scene::Override& change : changes) edits = withEdit(edits, change);
  return edits;
}

}  // namespace

void Player::moveCamera(const Json& json) {
  if (stage_ == nullptr) return;
  const JsonValue request(json);
  const bool moving = isSet(request, "moving");
  const Placed placed = placedBy(request);
  if (moving)
    recordDrag();
  else
    letGo();
  const auto changes = cameraChanges(*stage_, placed);
  std::vector<scene::Override> otherChanges;
  if (other_.stage() != nullptr) {
    // The right side gets the same pose, or the request contains another one if the right side has its own
    // view.
    const auto own = request.find("beside");
    const Placed others = own ? placedBy(*own) : placed;
    if (other_.ownFile() || other_.hasOwnView() || !(others == placed)) {
      otherChanges = cameraChanges(*other_.stage(), others);
      other_.setEdits(withEdits(other_.edits(), otherChanges));
    }
  }
  if (!load(text_, withEdits(edits_, changes), moving) || moving || !options_.edit) return;
  // A camera with follow, track, orbit or similar stays an edit, so that the file keeps its definition.
  const bool right = isSet(request, "right") && other_.stage() != nullptr && other_.ownFile();
  const auto& written = right ? otherChanges : changes;
  if (written.size() < 2) return;
  for (const scene::Override& change : written)
    if (right)
      writeOther(change, change.path);
    else
      writeFile(change, change.path);
}

void Player::setValue(const Json& json) {
  const JsonValue request(json);
  const bool moving = isSet(request, "moving");
  const scene::Override change{request.at("path").text(), request.at("value").json().dump()};
  if (moving)
    recordDrag();
  else
    letGo();
  if (isSet(request, "beside")) {
    setOther(withEdit(other_.edits(), change), moving);
    if (!moving && options_.edit && other_.ownFile()) writeOther(change, change.path);
  } else {
    if (std::any_of(options_.source.given.begin(), options_.source.given.end(),
                    [&](const scene::Override& given) { return given.path == change.path; }))
      fail(ExitCode::usage, "{} is set on the command line, which overrides edits", change.path);
    if (!load(text_, withEdit(edits_, change), moving)) {
      // The previous scene is still shown, so its error state is restored.
      const std::string said = mistakes_;
      mistakes_.clear();
      unread_ = false;
      throw UserError(ExitCode::usage, said, UserError::Form::report);
    }
    if (!moving && options_.edit) writeFile(change, change.path);
  }
  if (moving)
    moved_ = Clock::now();  // Building a world may have taken longer than the wait before the
                            // full picture.
}

/// Sets the values that apply only to the right side, and turns this side on. On an error, restores the
/// previous values and throws.
void Player::setOther(std::vector<scene::Override> edits, bool moving) {
  if (stage_ == nullptr) return;
  const bool was = other_.on();
  const auto before = other_.edits();
  other_.turn(true);
  other_.setEdits(std::move(edits));
  showOther(moving, false);
  if (other_.mistakes().empty()) return;
  const std::string said = other_.mistakes();
  other_.setEdits(before);
  other_.turn(was);
  showOther(moving, false);
  throw UserError(ExitCode::usage, said, UserError::Form::report);
}

/// Turns the right side on or off.
void Player::setBeside(const Json& json) {
  const JsonValue request(json);
  const bool on = request.at("on").boolean();
  difference_ = isSet(request, "difference");
  other_.turn(on);
  showOther(false, false);
}

/// Undoes all edits, or the edit of one path and the edits below it.
void Player::forget(const Json& json) {
  const JsonValue request(json);
  const bool beside = isSet(request, "beside");
  std::vector<scene::Override> left;
  if (const auto path = request.find("path"))
    for (const scene::Override& edit : beside ? other_.edits() : edits_)
      if (edit.path != path->text() && !edit.path.starts_with(path->text() + ".")) left.push_back(edit);
  if (!beside)
    load(text_, std::move(left), false);
  else if (other_.on())
    setOther(std::move(left), false);
}

/// Turns the comparison with baselines on or off.
void Player::compare(const Json& json) {
  const JsonValue request(json);
  const bool on = request.at("on").boolean();
  const bool right = isSet(request, "beside") && other_.stage() != nullptr;
  if (right != beside_.right()) beside_.choose(right ? other_.options().source : options_.source, right);
  beside_.turn(on);
  watch();
  compareWithBaseline();
}

/// Adds the shown frame to the frames that `simreel test` compares.
void Player::testThisFrame() {
  if (stage_ == nullptr) return;
  const scene::Override change = beside_.withFrame(compared(), target_);
  if (beside_.right() && other_.ownFile())
    writeOther(change, change.path);
  else
    writeFile(change, change.path);
}

/// Renders the shown frame or the whole sequence in another process.
void Player::renderIt(const Json& json) {
  if (options_.output.empty())
    fail(ExitCode::usage, "rendering is off; start the server with simreel serve --output FOLDER");
  if (stage_ == nullptr) return;
  const JsonValue request(json);
  const bool other = isSet(request, "beside") && other_.stage() != nullptr;
  std::vector<std::string> words = wordsOf(other);
  std::string name = (other ? options_.other.source.file : options_.source.file).stem().string();
  if (other && !other_.ownFile()) name += "_beside";
  if (isSet(request, "all"))
    child_.start(std::move(words), fmt::format("0-{}", lastFrame()), options_.output / name);
  else
    child_.start(std::move(words), std::to_string(target_),
                 options_.output / fmt::format("{}_{:06}.png", name, target_));
}

void Player::lookAtRender() {
  using State = RenderChild::Progress::State;
  const RenderChild::Progress now = child_.look();
  if (now == rendered_) return;
  rendered_ = now;
  std::string link;
  if (now.state == State::done && child_.isPicture()) {
    link = "render.png";
    hub_.offer(link, readFileOf(now.output));
  }
  hub_.tell("render", nlohmann::json{{"kind", "render"},
                                     {"state", now.state == State::running ? "running"
                                               : now.state == State::done  ? "done"
                                                                           : "failed"},
                                     {"done", now.done},
                                     {"total", now.total},
                                     {"output", now.output},
                                     {"link", link},
                                     {"text", now.text}}
                          .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

/// Sends information about a clicked pixel. All viewers may request it, not only the editor.
void Player::pick(std::uint64_t viewer, const Json& json) {
  const JsonValue request(json);
  if (!request.at("asks").is("pixel")) request.at("asks").wrong("must be \"pixel\"");
  const glm::dvec2 place(request.at("x").number(), request.at("y").number());
  if (stage_ == nullptr || !isAtTarget()) return;
  const bool other = isSet(request, "beside") && other_.stage() != nullptr;
  const PixelInfo answer = (other ? *other_.stage() : *stage_).ask(place);
  nlohmann::json rows = nlohmann::json::array();
  for (const PixelInfo::Row& row : answer.rows)
    rows.push_back(row.value ? nlohmann::json{row.name, *row.value, row.text}
                             : nlohmann::json{row.name, row.text, nullptr});
  hub_.answer(viewer, nlohmann::json{{"kind", "answer"},
                                     {"title", answer.title},
                                     {"frame", stage_->frame()},
                                     {"rows", std::move(rows)}}
                          .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace simreel::serve

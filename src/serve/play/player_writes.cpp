#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"
#include "serve/edit/brush.hpp"
#include "serve/edit/place_value.hpp"
#include "serve/play/player.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::serve {

namespace {

/// Replaces a file's text atomically and keeps its permissions.
void replaceText(const std::filesystem::path& named, const std::string& text) {
  const std::filesystem::path file = std::filesystem::weakly_canonical(named);
  const auto mode = std::filesystem::status(file).permissions();
  PartFile written(file);
  written.append(std::as_bytes(std::span(text)));
  std::error_code ignored;
  std::filesystem::permissions(file.string() + ".part", mode, ignored);
  written.finish();
}

std::vector<scene::Override> editsWithout(const std::vector<scene::Override>& edits,
                                          const std::string& path) {
  std::vector<scene::Override> left;
  for (const scene::Override& edit : edits)
    if (edit.path != path) left.push_back(edit);
  return left;
}

}  // namespace

/// Moves a value from the edits into the file.
void Player::writeFile(const scene::Override& change, const std::string& edited) {
  readFile();  // A text editor may have written the file in the meantime.
  const std::string text = withValue(text_, change);
  std::vector<scene::Override> left = editsWithout(edits_, edited);
  static_cast<void>(readScript(options_.source, text, left));  // readScript() throws if the new text has
                                                               // errors.
  replaceText(options_.source.file, text);
  // Records the file's new version immediately, so that later writes by other programs are noticed.
  files_.know(options_.source.file);
  text_ = text;
  load(text_, std::move(left), false);
}

void Player::writeOther(const scene::Override& change, const std::string& edited) {
  const SceneSource source = other_.options().source;
  if (std::any_of(source.given.begin(), source.given.end(),
                  [&](const scene::Override& given) { return given.path == change.path; }))
    fail(ExitCode::usage, "{} is set on the command line, which overrides edits", change.path);
  other_.readFile();
  if (!other_.unreadable().empty())
    throw UserError(ExitCode::usage, other_.unreadable(), UserError::Form::report);
  const std::string text = withValue(other_.text(), change);
  std::vector<scene::Override> left = editsWithout(other_.edits(), edited);
  static_cast<void>(readScript(source, text, left));
  replaceText(source.file, text);
  files_.know(source.file);
  other_.setText(text);
  other_.setEdits(std::move(left));
  showOther(false, false);
}

/// Paints a brush segment at the current frame: adds an entry to the "strokes" of the field under the
/// mouse. States before this frame stay valid.
void Player::paint(const Json& json) {
  if (stage_ == nullptr) return;
  const JsonValue request(json);
  const auto beside = request.find("beside");
  const bool right = beside && beside->boolean() && other_.stage() != nullptr;
  Stage& stage = right ? *other_.stage() : *stage_;
  const auto placeAt = [&](const char* name) {
    const JsonValue value = request.at(name);
    return fieldAt(stage.script().scene, stage.world(), {value.at(0).number(), value.at(1).number()});
  };
  const auto from = placeAt("from"), to = placeAt("to");
  if (!from || !to || from->object != to->object)
    fail(ExitCode::usage,
         "there is no field to paint; only cells that are drawn over the picture can be painted");
  recordDrag();
  playing_ = false;
  const scene::Scene& shown = stage.script().scene;
  const auto object = std::find_if(shown.objects.begin(), shown.objects.end(),
                                   [&](const scene::Object& one) { return one.name == from->object; });
  const nlohmann::json scene = parseStrictJson(stage.script().asRun);
  const nlohmann::json& given = scene.at("objects").at(object->name).at(object->kind);
  const std::string path = fmt::format("objects.{}.{}.strokes", object->name, object->kind);
  // A fluid advances by one frame with each segment.
  if (object->kind == "fluid" && from->cell != to->cell) target_ = std::min(target_ + 1, lastFrame());
  BrushPiece piece{target_ / shown.time.fps, from->cell, to->cell, request.at("radius").number()};
  if (const auto value = request.find("value")) piece.value = value->number();
  nlohmann::json strokes = strokesOf(*object, given);
  nlohmann::json stroke = strokeOf(*object, given, piece);
  const scene::Override written{fmt::format("{}.{}", path, strokes.size()), stroke.dump()};
  strokes.push_back(std::move(stroke));
  const scene::Override whole{path, strokes.dump()};
  // If the file contains strokes, only the new entry is written. Otherwise the whole list is written. The
  // result equals the edit, so the states stay valid.
  const scene::Override& change = given.contains("strokes") && strokes.size() > 1 ? written : whole;
  if (right) {
    setOther(withEdit(other_.edits(), whole), false);
    if (options_.edit && other_.ownFile()) writeOther(change, path);
    return;
  }
  if (load(text_, withEdit(edits_, whole), false) && options_.edit) writeFile(change, path);
}

}  // namespace simreel::serve

#pragma once
#include "scene/scene.hpp"
#include "serve/script/watched_files.hpp"
#include "sim/world/survey.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::serve {

/// Where a scene comes from.
struct SceneSource {
  std::filesystem::path file;
  std::vector<scene::Override> given;  ///< of the command line
  std::vector<std::filesystem::path> folders;
};

/// A scene as it is shown: the file's text with what was changed over it.
struct Script {
  std::string text;                    ///< of the file
  std::vector<scene::Override> edits;  ///< over the file and what the command line gives
  scene::Scene scene;
  scene::Scene draft;      ///< the same without lens, shutter and rays: for pictures that have to be quick
  std::string asRun;       ///< scene::sceneAsRun
  std::string simulation;  ///< scene::simulationHash of it without what only shows (withoutWhatShows)
  std::map<std::filesystem::path, FileStamp> files;  ///< that it names, as they were when it was read
  bool fieldsAlone = false;                          ///< whether nothing but fields is drawn
  sim::Survey survey;    ///< where its objects went, if placeCamera() had to know
  std::string surveyOf;  ///< what was simulated for that: another script's, where it is borrowed
};

/// Reads it. Throws UserError(usage) with every mistake.
[[nodiscard]] std::shared_ptr<Script> readScript(const SceneSource& source, const std::string& text,
                                                 std::vector<scene::Override> edits);

/// Places the camera of a scene whose motion only a run tells (sim::surveyMotion), on the current context.
/// `known`: a script whose run does where it is the same, or where it was nearly so and changes on at once
/// (`moving`); null: none. Throws what the run does.
void placeCamera(Script& script, const Script* known, bool moving);
/// Whether cameras and stages that nobody placed stand alike.
[[nodiscard]] bool framedAlike(const Script& before, const Script& after);

/// How much of what is shown has to be made anew for another script.
enum class Change {
  nothing,
  look,     ///< values that each picture reads from the scene anyway
  drawing,  ///< what the renderer was made with
  dress,    ///< what objects were made with, though no state depends on it
  simulation,
};
[[nodiscard]] Change changeBetween(const Script& before, const Script& after);
/// Whether a renderer made for one draws the other's objects, too.
[[nodiscard]] bool drawsAlike(const Script& before, const Script& after);
/// What states come from. Of its own: scripts that are shown take over what others look like.
struct Simulated {
  std::string asRun, simulation;  ///< as in Script
  std::map<std::filesystem::path, FileStamp> files;
};
[[nodiscard]] inline Simulated simulatedOf(const Script& script) {
  return {script.asRun, script.simulation, script.files};
}
/// The first frame whose state may be another one; farFrame: none.
[[nodiscard]] int firstOther(const Simulated& before, const Script& after);
inline constexpr int farFrame = 1 << 30;
/// Objects that differ in values that a world takes over as it goes (sim::Retunable), where nothing else
/// differs; else none.
[[nodiscard]] std::vector<std::size_t> retunedObjects(const Script& before, const Script& after);
/// For Change::look: takes over those values, in place.
void takeLook(Script& shown, Script& from);

/// Dotted paths of members that differ between two texts as scene::sceneAsRun writes them; of lists and
/// of what is there in one alone, the whole.
[[nodiscard]] std::set<std::string> differingPaths(std::string_view before, std::string_view after);

/// The edits with `path` set: one of the same path gives way, and those below it.
[[nodiscard]] std::vector<scene::Override> withEdit(std::span<const scene::Override> edits,
                                                    const scene::Override& change);

}  // namespace simreel::serve

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

/// Source of a scene.
struct SceneSource {
  std::filesystem::path file;
  std::vector<scene::Override> given;  ///< overrides from the command line
  std::vector<std::filesystem::path> folders;
};

/// Scene in the form that is shown, which is the file's text with the edits made on the page.
struct Script {
  std::string text;                    ///< text of the scene file
  std::vector<scene::Override> edits;  ///< values that take precedence over the file and the command line
  scene::Scene scene;
  scene::Scene draft;      ///< the scene without lens, shutter and ray tracing, for drafts
  std::string asRun;       ///< result of scene::sceneAsRun
  std::string simulation;  ///< scene::simulationHash of asRun after withoutAppearance()
  /// Files that the scene names, as they were when it was read.
  std::map<std::filesystem::path, FileStamp> files;
  bool fieldsAlone = false;  ///< true if only fields are drawn
  sim::Survey survey;        ///< extents of the moving objects; set if placeCamera() needed them
  /// Identifies the simulation from which `survey` comes. This is another script's simulation if the survey
  /// was reused.
  std::string surveyOf;
};

/// Reads a script. Throws UserError(usage) with all errors.
[[nodiscard]] std::shared_ptr<Script> readScript(const SceneSource& source, const std::string& text,
                                                 std::vector<scene::Override> edits);

/// Places the automatic camera and stage of a scene whose extent is known only after a simulation of its
/// motion (sim::surveyMotion), and sets its automatic colour ranges; does nothing for scenes that need
/// neither. Uses the current context. `known`: script whose survey is reused if its simulation is the same;
/// may be null. While a value is dragged (`moving`), the survey of a different simulation is also reused.
/// Throws the errors of the simulation.
void placeCamera(Script& script, const Script* known, bool moving);
/// True if automatically placed cameras and stages are equal.
[[nodiscard]] bool framedAlike(const Script& before, const Script& after);

/// Parts of the display that must be rebuilt when another script is shown.
enum class Change {
  nothing,
  look,     ///< change of values that are read from the scene for each picture
  drawing,  ///< change of values that the renderer was built with
  dress,    ///< change of values that objects were built with but that do not affect states
  simulation,
};
[[nodiscard]] Change changeBetween(const Script& before, const Script& after);
/// True if a renderer that was built for one script can also draw the objects of the other script.
[[nodiscard]] bool drawsAlike(const Script& before, const Script& after);
/// Inputs from which states were computed. They are stored separately from the shown script, which is
/// modified when only its look changes.
struct Simulated {
  std::string asRun, simulation;  ///< copies of the members of Script
  std::map<std::filesystem::path, FileStamp> files;
};
[[nodiscard]] inline Simulated simulatedOf(const Script& script) {
  return {script.asRun, script.simulation, script.files};
}
/// Returns the first frame whose state may differ. Returns farFrame if all states are equal.
[[nodiscard]] int firstOther(const Simulated& before, const Script& after);
inline constexpr int farFrame = 1 << 30;
/// Returns the objects that differ in values that a running world can change (sim::Retunable). Returns an
/// empty list if anything else differs.
[[nodiscard]] std::vector<std::size_t> retunedObjects(const Script& before, const Script& after);
/// Copies the values that Change::look covers from `from` to `shown`.
void takeLook(Script& shown, Script& from);

/// Returns the dotted paths of members that differ between two texts written by scene::sceneAsRun. Lists,
/// and members that only one text has, count as a whole.
[[nodiscard]] std::set<std::string> differingPaths(std::string_view before, std::string_view after);

/// Returns the edits with `change` added. It replaces an edit of the same path and all edits below that
/// path.
[[nodiscard]] std::vector<scene::Override> withEdit(std::span<const scene::Override> edits,
                                                    const scene::Override& change);

}  // namespace simreel::serve

#pragma once
#include "scene/scene.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace simreel::batch {

/// One job of a sweep.
struct PlannedJob {
  /// Values of the varied parameters, in the order of SweepPlan::varied.
  std::vector<scene::Override> values;
  /// Hash of scene, values, frames, field format and program version. A result with a different hash does
  /// not belong to this job.
  std::string hash;
};

/// Plan of a sweep, stored as plan.json in the sweep's folder with one line for each job.
struct SweepPlan {
  std::filesystem::path folder;  ///< folder that contains plan.json; not stored in the plan
  std::string program;           ///< version of the program that wrote the plan
  /// Asset folders as absolute paths. The scene's own folder is first.
  std::vector<std::filesystem::path> assets;
  /// Overrides that apply to all jobs, before the job's own values.
  std::vector<scene::Override> overrides;
  std::string frames;               ///< argument of --frames; empty for all frames
  std::string fields;               ///< argument of --fields; empty if field files are not written
  std::vector<std::string> varied;  ///< paths of the varied parameters
  /// First frame of all jobs, if they have the same state at that frame and something must be simulated
  /// before it. This state is simulated once for all jobs. nullopt if a varied path affects the simulation.
  std::optional<int> sharedFrame;
  std::vector<PlannedJob> jobs;

  [[nodiscard]] std::filesystem::path planFile() const { return folder / "plan.json"; }
  /// Returns the path of the copy of the scene that was made when the sweep was planned.
  [[nodiscard]] std::filesystem::path sceneFile() const { return folder / "scene.json"; }
  /// Returns the name of a job in tables, which is also the name of its folder, such as "0007".
  [[nodiscard]] std::string name(std::size_t job) const;
  [[nodiscard]] std::filesystem::path jobFolder(std::size_t job) const;
  /// Returns the folder with the checkpoint of the shared frame.
  [[nodiscard]] std::filesystem::path sharedFolder() const { return folder / "shared"; }
  [[nodiscard]] std::filesystem::path sharedCheckpoint() const;
  /// Returns the overrides of all jobs, followed by this job's values.
  [[nodiscard]] std::vector<scene::Override> overridesOf(std::size_t job) const;
  /// Returns the job's values with shortened paths: "feed=0.03 kill=0.06".
  [[nodiscard]] std::string label(std::size_t job) const;
};

/// Returns the paths without their leading names. Each is as short as possible as long as all are
/// different, and consists of at least one name.
[[nodiscard]] std::vector<std::string> shortNames(const std::vector<std::string>& paths);

[[nodiscard]] std::string jobHash(const std::string& sceneHash, const std::string& frames,
                                  const std::string& fields);
/// Throws UserError(usage) if another version of the program wrote the plan, because results of this
/// version would then be recorded as results of the other.
void checkProgram(const SweepPlan& plan);

/// Sets the hashes of all jobs and `sharedFrame`. `text`: text of the scene. Throws UserError(usage) with
/// the errors of the first job whose scene has errors.
void checkJobs(SweepPlan& plan, const std::string& text);

[[nodiscard]] std::string planText(const SweepPlan& plan);
/// Reads plan.json in `folder`. Throws UserError(usage) with the file and the error in it.
[[nodiscard]] SweepPlan readSweepPlan(const std::filesystem::path& folder);

}  // namespace simreel::batch

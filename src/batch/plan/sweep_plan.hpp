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
  std::vector<scene::Override> values;  ///< of the parameters, in their order
  /// Of scene, values, frames and program: a result of another hash is not this job's.
  std::string hash;
};

/// All that there is to do in a sweep's folder: plan.json in it, a line for each job.
struct SweepPlan {
  std::filesystem::path folder;               ///< where the plan lies; not written
  std::string program;                        ///< version that wrote it
  std::vector<std::filesystem::path> assets;  ///< absolute: the scene's own folder first
  std::vector<scene::Override> overrides;     ///< of every job, before its values
  std::string frames;                         ///< as --frames takes them; empty: all
  std::string fields;                         ///< "npy", "pfm" or empty
  std::vector<std::string> varied;            ///< paths
  /// The first frame of each job, where no varied path touches the simulation and there is something to
  /// simulate before it: the state there is the same in all jobs, and is made once.
  std::optional<int> sharedFrame;
  std::vector<PlannedJob> jobs;

  [[nodiscard]] std::filesystem::path planFile() const { return folder / "plan.json"; }
  /// The scene as it was when the sweep was planned.
  [[nodiscard]] std::filesystem::path sceneFile() const { return folder / "scene.json"; }
  /// "0007": of a job's folder and in tables.
  [[nodiscard]] std::string name(std::size_t job) const;
  [[nodiscard]] std::filesystem::path jobFolder(std::size_t job) const;
  /// Where the checkpoint of the shared frame is kept.
  [[nodiscard]] std::filesystem::path sharedFolder() const { return folder / "shared"; }
  [[nodiscard]] std::filesystem::path sharedCheckpoint() const;
  /// Of every job and this one's values.
  [[nodiscard]] std::vector<scene::Override> overridesOf(std::size_t job) const;
  /// "feed=0.03 kill=0.06": the values with as much of their paths as tells them apart.
  [[nodiscard]] std::string label(std::size_t job) const;
};

/// The parameters' paths cut from the front as far as they stay different, and at least to one name.
[[nodiscard]] std::vector<std::string> shortNames(const std::vector<std::string>& paths);

[[nodiscard]] std::string jobHash(const std::string& sceneHash, const std::string& frames,
                                  const std::string& fields);
/// Throws UserError(usage) where another version of the program has written the plan: its jobs' results
/// would be said to be that one's.
void checkProgram(const SweepPlan& plan);

/// Sets the jobs' hashes, and what they share. Throws UserError(usage) with the report of the first job
/// whose scene has mistakes; `text` is the scene's.
void checkJobs(SweepPlan& plan, const std::string& text);

[[nodiscard]] std::string planText(const SweepPlan& plan);
/// Throws UserError(usage) naming the file and what is wrong in it.
[[nodiscard]] SweepPlan readSweepPlan(const std::filesystem::path& folder);

}  // namespace simreel::batch

#pragma once
#include "batch/plan/sweep_plan.hpp"
#include "cli/options/scene_options.hpp"
#include "cli/options/slurm_options.hpp"
#include "frame/file/output_lock.hpp"
#include "gl/context.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace simreel::cli {

/// Options for running the jobs of a sweep, used by `simreel sweep SCENE` and `sweep retry`.
struct SweepRunOptions {
  std::string jobs = "1";
  gl::ContextOptions on;
  std::string progress = "auto";
  SlurmOptions cluster;

  void add(CLI::App& command);
};

struct SweepOptions {
  SceneOptions scene;
  std::vector<std::string> vary;
  bool zip = false, grid = false;
  std::optional<std::size_t> sample;
  std::string output;
  std::string frames, fields;
  bool planOnly = false;
  bool overwrite = false;
  SweepRunOptions run;
};

/// Locks a sweep's folder. The same sweep may run several times at once, and its processes share the jobs.
/// `text`: plan and scene of the sweep. Throws UserError(inputOutput) if another sweep is running there.
[[nodiscard]] frame::OutputLock lockSweep(const batch::SweepPlan& plan, const std::string& text);

/// Runs those `jobs` that are not done, locally or through Slurm. Sets the exit code from the state of all
/// jobs.
void runSweep(const batch::SweepPlan& plan, const std::vector<std::size_t>& jobs,
              const SweepRunOptions& how);

/// Adds status, retry, collect and job below `sweep`.
void addSweepFollowers(CLI::App& sweep);

}  // namespace simreel::cli

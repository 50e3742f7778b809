#pragma once
#include "batch/plan/sweep_plan.hpp"
#include "batch/sweep/job_result.hpp"
#include "frame/sink/progress.hpp"
#include "gl/context.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace simreel::batch {

/// Where a job of a sweep is.
enum class JobState {
  missing,  ///< nobody has begun it
  queued,   ///< nobody is at it, and a cluster still has it
  running,  ///< some process has its folder
  aborted,  ///< begun, and nobody is at it any more: it goes on from its checkpoint
  failed,   ///< ended with an error
  done
};
[[nodiscard]] const char* stateName(JobState state);

struct JobStatus {
  JobState state = JobState::missing;
  std::optional<JobResult> result;  ///< of a job that is done or failed
  std::string why;                  ///< of one that ended and is not done all the same
};
[[nodiscard]] JobStatus statusOf(const SweepPlan& plan, std::size_t job);

/// How this process's part in a job ended.
struct JobEnd {
  JobResult result;
  int signal = 0;          ///< that interrupted it; nothing is stored as its result then
  bool elsewhere = false;  ///< another process is at it: it was left alone
};

/// Renders a job into its folder, or goes on with one that was interrupted there, and writes its result,
/// an error's too. One that is done already is left as it is. `scratch`: a folder of this machine's own to
/// render in; empty: none.
[[nodiscard]] JobEnd runSweepJob(const SweepPlan& plan, std::size_t job, const gl::Context& context,
                                 frame::Progress& progress, const std::string& command,
                                 const std::filesystem::path& scratch = {});
/// Simulates what all jobs share, if anything, and keeps its last state for them; they do without where it
/// is not there. Returns the signal that interrupted it, or 0. Throws UserError.
[[nodiscard]] int makeShared(const SweepPlan& plan, const gl::Context& context, frame::Progress& progress,
                             const std::string& command);
[[nodiscard]] bool lacksShared(const SweepPlan& plan);
/// For a job whose process ended before it could say how. Throws UserError(inputOutput).
JobResult writeLostResult(const SweepPlan& plan, std::size_t job, const std::string& how);
/// Before another plan takes the place of this one: what is made after this one goes, but for the jobs
/// that both have. Throws UserError(inputOutput) where a job is being rendered.
void removeOthers(const SweepPlan& old, const SweepPlan& next);

}  // namespace simreel::batch

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

/// State of a job of a sweep.
enum class JobState {
  missing,  ///< the job has not begun
  queued,   ///< the job is waiting in a cluster's queue
  running,  ///< the job is running: a process holds the lock of the job's folder
  aborted,  ///< the job has begun, but no process runs it; it can continue from its checkpoint
  failed,   ///< the job has ended with an error
  done
};
[[nodiscard]] const char* stateName(JobState state);

struct JobStatus {
  JobState state = JobState::missing;
  std::optional<JobResult> result;  ///< result of a job that is done or failed
  std::string why;                  ///< reason why a job that has ended does not count as done
};
[[nodiscard]] JobStatus statusOf(const SweepPlan& plan, std::size_t job);

/// Outcome of a call of runSweepJob().
struct JobEnd {
  JobResult result;
  int signal = 0;          ///< signal that interrupted the job (no result is stored then), or 0
  bool elsewhere = false;  ///< true if another process runs the job, so that the call did nothing
};

/// Renders a job into its folder, or continues an interrupted one. Writes the result, even after an error.
/// Does nothing if the job is already done. `scratch`: local folder to render in; empty if none is used.
[[nodiscard]] JobEnd runSweepJob(const SweepPlan& plan, std::size_t job, const gl::Context& context,
                                 frame::Progress& progress, const std::string& command,
                                 const std::filesystem::path& scratch = {});
/// Simulates the frames that are equal in all jobs, if there are any, and stores the last state for the
/// jobs. Jobs can also run without that state. Returns the signal that interrupted the simulation, or 0.
/// Throws UserError.
[[nodiscard]] int makeShared(const SweepPlan& plan, const gl::Context& context, frame::Progress& progress,
                             const std::string& command);
[[nodiscard]] bool lacksShared(const SweepPlan& plan);
/// Writes the result of a job whose process ended before writing one. `how`: the way in which the process
/// ended. Throws UserError(inputOutput).
JobResult writeLostResult(const SweepPlan& plan, std::size_t job, const std::string& how);
/// Removes all files of plan `old` before plan `next` replaces it, except the files of jobs that are in
/// both plans. Throws UserError(inputOutput) if a job is being rendered.
void removeOthers(const SweepPlan& old, const SweepPlan& next);

}  // namespace simreel::batch

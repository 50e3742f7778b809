#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace simreel::batch {

/// Job or job array that Slurm has accepted.
struct Submitted {
  std::string work;        ///< name of the work (Slurm::Work::name)
  std::string id;          ///< Slurm's id of the job
  std::size_t offset = 0;  ///< difference between an item's number and its index in the Slurm array
};

/// Appends the job to the list of submitted jobs in `folder`, which contains the scripts. Throws
/// UserError(inputOutput).
void noteSubmitted(const std::filesystem::path& folder, const Submitted& job);

/// Jobs that were submitted from a folder and that are still waiting or running in Slurm.
class SlurmQueue {
 public:
  /// Runs `squeue` if jobs were submitted from `folder`. An empty path means that no jobs were submitted.
  /// If squeue fails, warns and treats the queue as empty.
  explicit SlurmQueue(const std::filesystem::path& folder);

  /// True if item `number` of this work is queued. A job that is not an array has only item 0.
  [[nodiscard]] bool has(const std::string& work, std::size_t number) const;
  [[nodiscard]] bool empty() const { return numbers_.empty(); }

 private:
  std::map<std::string, std::set<std::size_t>> numbers_;  ///< queued item numbers by name of the work
};

}  // namespace simreel::batch

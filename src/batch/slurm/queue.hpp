#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace simreel::batch {

/// A job, or an array of jobs, that Slurm took.
struct Submitted {
  std::string work;        ///< Slurm::Work::name
  std::string id;          ///< Slurm's
  std::size_t offset = 0;  ///< of the work's numbers to the array's
};

/// Adds it to the list in `folder`, that of the scripts. Throws UserError(inputOutput).
void noteSubmitted(const std::filesystem::path& folder, const Submitted& job);

/// What Slurm still has of all that was submitted from a folder, waiting or running.
class SlurmQueue {
 public:
  /// Asks `squeue`, if anything was submitted (empty folder: no); nothing is queued where it does not
  /// answer, with a warning.
  explicit SlurmQueue(const std::filesystem::path& folder);

  /// Whether a number of this work is; a job that is no array has 0.
  [[nodiscard]] bool has(const std::string& work, std::size_t number) const;
  [[nodiscard]] bool empty() const { return numbers_.empty(); }

 private:
  std::map<std::string, std::set<std::size_t>> numbers_;  ///< by work
};

}  // namespace simreel::batch

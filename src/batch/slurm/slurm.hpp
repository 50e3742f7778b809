#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace simreel::batch {

/// Submits jobs to a Slurm cluster through `sbatch`. A job's script replaces its process by simreel
/// (`exec`), so that simreel receives the signals that Slurm sends before it ends or requeues a job.
class Slurm {
 public:
  /// `folder`: folder for scripts and logs, visible to all nodes. `more`: additional arguments for sbatch.
  /// Throws UserError(usage) if Slurm is not installed.
  Slurm(const std::filesystem::path& folder, std::vector<std::string> more);

  /// Arguments of simreel for one job, or for each job of an array.
  struct Work {
    std::string name;                     ///< name of the job and of its script
    std::vector<std::string> arguments;   ///< arguments for simreel; in an array, the item's number is
                                          ///< appended
    std::vector<std::size_t> numbers;     ///< item numbers in ascending order; empty for a single job
    std::vector<std::string> after = {};  ///< ids of jobs that must succeed before this work starts
    bool afterAnyResult = false;          ///< true if the jobs in `after` only have to end, with any result
  };
  /// Submits the work and returns the jobs' ids. Splits arrays that are too long for the cluster. Throws
  /// UserError(inputOutput) with sbatch's message.
  std::vector<std::string> submit(const Work& work);

 private:
  std::string submitOne(const Work& work, const std::string& array, std::size_t offset, std::size_t part);

  std::filesystem::path folder_;
  std::vector<std::string> more_;
  std::size_t maxArraySize_;
};

/// Splits text into words like a shell: at blanks, except inside ' or ". Throws UserError(usage).
[[nodiscard]] std::vector<std::string> shellWords(const std::string& text);

/// Returns the numbers minus `offset` in the syntax of sbatch --array: "0-3,7".
[[nodiscard]] std::string arrayText(const std::vector<std::size_t>& numbers, std::size_t offset);

/// Splits ascending numbers into parts. In each part, the numbers differ by less than `maxSize`, and the
/// part's text fits into one command-line argument.
[[nodiscard]] std::vector<std::vector<std::size_t>> splitArray(const std::vector<std::size_t>& numbers,
                                                               std::size_t maxSize);

}  // namespace simreel::batch

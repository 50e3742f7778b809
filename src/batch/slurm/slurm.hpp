#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace simreel::batch {

/// Jobs of a Slurm cluster, submitted by its own `sbatch`. Each runs a script that becomes simreel
/// (`exec`), so what Slurm sends before it ends or requeues a job reaches the program.
class Slurm {
 public:
  /// `folder`: where scripts and what jobs say go, seen by every node. `more`: further words for sbatch.
  /// Throws UserError(usage) where there is no sbatch.
  Slurm(const std::filesystem::path& folder, std::vector<std::string> more);

  /// What one job, or each of an array, runs.
  struct Work {
    std::string name;                     ///< of the job and its script
    std::vector<std::string> arguments;   ///< of simreel; the job's number follows where there are some
    std::vector<std::size_t> numbers;     ///< ascending; empty: a job that is no array
    std::vector<std::string> after = {};  ///< ids of jobs that have to be done well before
    bool however = false;                 ///< or to have ended, however that was
  };
  /// Splits arrays where the cluster allows no longer ones. Returns the ids. Throws UserError(inputOutput)
  /// with what sbatch said.
  std::vector<std::string> submit(const Work& work);

 private:
  std::string submitOne(const Work& work, const std::string& array, std::size_t offset, std::size_t part);

  std::filesystem::path folder_;
  std::vector<std::string> more_;
  std::size_t maxArraySize_;
};

/// Words as a shell tells them apart: by blanks, with ' and " around what holds some. Throws
/// UserError(usage).
[[nodiscard]] std::vector<std::string> shellWords(const std::string& text);

/// Numbers as sbatch --array takes them, less `offset`: "0-3,7".
[[nodiscard]] std::string arrayText(const std::vector<std::size_t>& numbers, std::size_t offset);

/// Cuts ascending numbers where one is `maxSize` or more above the first of its part, or the part's text
/// would be longer than a system takes as one word.
[[nodiscard]] std::vector<std::vector<std::size_t>> splitArray(const std::vector<std::size_t>& numbers,
                                                               std::size_t maxSize);

}  // namespace simreel::batch

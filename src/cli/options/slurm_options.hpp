#pragma once
#include "batch/slurm/slurm.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace simreel::cli {

/// --slurm, --sbatch and --scratch: of commands whose work many machines can share.
struct SlurmOptions {
  bool slurm = false;
  std::vector<std::string> sbatch;
  std::string scratch;

  void add(CLI::App& command);
  /// --scratch alone, for the commands that the jobs run.
  void addScratch(CLI::App& command);
  /// Throws UserError(usage).
  [[nodiscard]] batch::Slurm cluster(const std::filesystem::path& folder) const;
  /// What of it the jobs are told.
  [[nodiscard]] std::vector<std::string> arguments() const;
};

}  // namespace simreel::cli

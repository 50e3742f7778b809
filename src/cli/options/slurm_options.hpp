#pragma once
#include "batch/slurm/slurm.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace simreel::cli {

/// --slurm, --sbatch and --scratch, for commands whose work several machines can share.
struct SlurmOptions {
  bool slurm = false;
  std::vector<std::string> sbatch;
  std::string scratch;

  void add(CLI::App& command);
  /// Adds only --scratch, for the commands that the cluster's jobs run.
  void addScratch(CLI::App& command);
  /// Returns the cluster settings. Throws UserError(usage).
  [[nodiscard]] batch::Slurm cluster(const std::filesystem::path& folder) const;
  /// Returns the options that are passed on to the cluster's jobs.
  [[nodiscard]] std::vector<std::string> arguments() const;
};

}  // namespace simreel::cli

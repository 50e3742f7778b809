#pragma once
#include "batch/slurm/slurm.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace simreel::cli {

/// Options --slurm, --sbatch and --scratch of commands whose work can be divided among several machines.
struct SlurmOptions {
  bool slurm = false;
  std::vector<std::string> sbatch;
  std::string scratch;

  /// Adds all three to a command that has the option --jobs.
  void add(CLI::App& command);
  /// Adds only --scratch, for the commands that run inside the cluster's jobs.
  void addScratch(CLI::App& command);
  /// Returns the cluster settings. Throws UserError(usage).
  [[nodiscard]] batch::Slurm cluster(const std::filesystem::path& folder) const;
  /// Returns the options that are passed to the cluster's jobs.
  [[nodiscard]] std::vector<std::string> arguments() const;
};

}  // namespace simreel::cli

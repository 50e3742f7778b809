#include "cli/options/slurm_options.hpp"

#include "base/error.hpp"

#include <utility>

#include <CLI/CLI.hpp>

namespace simreel::cli {

void SlurmOptions::add(CLI::App& command) {
  auto* there =
      command.add_flag("--slurm", slurm, "Submit the work to a Slurm cluster instead of doing it here")
          ->excludes(command.get_option("--jobs"));
  command
      .add_option(
          "--sbatch", sbatch,
          "With --slurm: further options for sbatch, such as '--partition=gpu --gres=gpu:1'; repeatable")
      ->allow_extra_args(false)
      ->needs(there);
  addScratch(command);
}

void SlurmOptions::addScratch(CLI::App& command) {
  command.add_option("--scratch", scratch,
                     "Folder on the rendering machine's own disk to work in, such as '$TMPDIR'; the "
                     "results are copied to their place at the end");
}

batch::Slurm SlurmOptions::cluster(const std::filesystem::path& folder) const {
  std::vector<std::string> words;
  for (const std::string& text : sbatch)
    for (std::string& word : batch::shellWords(text)) words.push_back(std::move(word));
  return {folder, std::move(words)};
}

std::vector<std::string> SlurmOptions::arguments() const {
  if (scratch.empty()) return {};
  return {"--scratch", scratch};
}

}  // namespace simreel::cli

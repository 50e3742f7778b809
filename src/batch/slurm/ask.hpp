#pragma once
#include <string>
#include <vector>

namespace simreel::batch {

/// What a command of Slurm's came to.
struct Answer {
  int error = 0;   ///< errno where it could not be started
  int status = 0;  ///< as waitpid has it
  std::string output, messages;

  [[nodiscard]] bool fine() const { return error == 0 && status == 0; }
  /// The first line of what it said, or of what the system did.
  [[nodiscard]] std::string why() const;
};

/// Runs a program found along PATH, and waits for it.
[[nodiscard]] Answer ask(const std::vector<std::string>& words);

[[nodiscard]] inline std::string firstLine(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace simreel::batch

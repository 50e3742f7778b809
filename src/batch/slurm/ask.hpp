#pragma once
#include <string>
#include <vector>

namespace simreel::batch {

/// Result of a Slurm command.
struct Answer {
  int error = 0;   ///< errno if the command could not be started
  int status = 0;  ///< exit status as set by waitpid()
  std::string output, messages;

  [[nodiscard]] bool fine() const { return error == 0 && status == 0; }
  /// Returns the first line of the error output, or the system's error message if the command could not be
  /// started.
  [[nodiscard]] std::string why() const;
};

/// Runs a program found in PATH and waits until it ends.
[[nodiscard]] Answer ask(const std::vector<std::string>& words);

[[nodiscard]] inline std::string firstLine(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace simreel::batch

#pragma once
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace simreel::serve {

/// Child process that runs this program with another command, while the parent process keeps showing
/// pictures.
class ChildProcess {
 public:
  ChildProcess() = default;
  /// Ends the process if it is running.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Starts the program. `arguments` begin with the command. No other process may be running. Throws
  /// UserError(inputOutput) if the process cannot be started.
  void start(const std::vector<std::string>& arguments);
  [[nodiscard]] bool running() const { return process_ > 0; }
  /// Returns the exit code (-1 if a signal ended the process) at the first call after the process has
  /// ended. Returns nullopt at all other times.
  [[nodiscard]] std::optional<int> ended();
  /// output() and messages() return the end of the process's standard output and error output so far. The
  /// first line may be incomplete.
  [[nodiscard]] std::string output() const;
  [[nodiscard]] std::string messages() const;

 private:
  void close();

  pid_t process_ = 0;
  int output_ = -1, messages_ = -1;
};

}  // namespace simreel::serve

#pragma once
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace simreel::serve {

/// This program as a process of its own, which goes on while pictures are shown.
class ChildProcess {
 public:
  ChildProcess() = default;
  /// Ends one that runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// `arguments` begin with the command. One at a time (an invariant). Throws UserError(inputOutput) where
  /// none can be started.
  void start(const std::vector<std::string>& arguments);
  [[nodiscard]] bool running() const { return process_ > 0; }
  /// Its exit code (-1: it was ended by a signal) once, when it has ended; nothing before.
  [[nodiscard]] std::optional<int> ended();
  /// The end of what it has said so far, or said in all; a first line may have lost its beginning.
  [[nodiscard]] std::string output() const;
  [[nodiscard]] std::string messages() const;

 private:
  void close();

  pid_t process_ = 0;
  int output_ = -1, messages_ = -1;
};

}  // namespace simreel::serve

#pragma once
#include "base/clock.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace simreel::golden {

/// A shell command whose output is read as it comes. Its messages are kept. Waiting for it throws
/// Interrupted after SIGINT or SIGTERM; whenever the object goes, the command and all it started are ended.
class ChildCommand {
 public:
  /// `name` is how messages call it, for example "this side". Throws UserError(inputOutput) when it cannot
  /// be started. `arguments` are $1 and so on to the command. After so many seconds it is ended, and
  /// waiting for it throws UserError(inputOutput); 0: never.
  ChildCommand(const std::string& command, std::string name, const std::vector<std::string>& arguments = {},
               double timeout = 0);
  ~ChildCommand();
  ChildCommand(const ChildCommand&) = delete;
  ChildCommand& operator=(const ChildCommand&) = delete;
  ChildCommand(ChildCommand&&) = delete;
  ChildCommand& operator=(ChildCommand&&) = delete;

  /// The next line without its end; nothing after the last.
  [[nodiscard]] std::optional<std::string> line();
  /// All that is left to read. Throws UserError(inputOutput) beyond `maxBytes`.
  [[nodiscard]] std::vector<std::byte> rest(std::size_t maxBytes);
  /// Waits for its end. Throws UserError with its own message unless it ended with 0: usage and device
  /// errors of a simreel keep their code, anything else is inputOutput.
  void finish();

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  /// Waits for more and appends it to read_; false at the end.
  bool more();
  [[noreturn]] void failed(int status);
  void checkTime();
  void end() noexcept;

  std::string name_;
  Clock::time_point began_ = Clock::now();
  double timeout_;
  pid_t process_ = -1;
  int output_ = -1;
  int messages_ = -1;
  std::string read_;  ///< not yet handed out
};

}  // namespace simreel::golden

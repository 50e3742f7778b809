#pragma once
#include "base/clock.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace simreel::golden {

/// A shell command whose output is read as it arrives. Messages (stderr) are stored in memory. Waiting for
/// the command throws Interrupted after SIGINT or SIGTERM. The destructor kills the command and all
/// processes that it started.
class ChildCommand {
 public:
  /// Starts the command. `arguments` become $1, $2 and so on. `name` appears in messages: "this side".
  /// After `timeout` seconds (0 means never) the command is killed, and waiting for it throws
  /// UserError(inputOutput). Throws UserError(inputOutput) if the command cannot be started.
  ChildCommand(const std::string& command, std::string name, const std::vector<std::string>& arguments = {},
               double timeout = 0);
  ~ChildCommand();
  ChildCommand(const ChildCommand&) = delete;
  ChildCommand& operator=(const ChildCommand&) = delete;
  ChildCommand(ChildCommand&&) = delete;
  ChildCommand& operator=(ChildCommand&&) = delete;

  /// Returns the next line without its line end, or nothing after the last line.
  [[nodiscard]] std::optional<std::string> line();
  /// Returns all remaining output. Throws UserError(inputOutput) if it exceeds `maxBytes`.
  [[nodiscard]] std::vector<std::byte> rest(std::size_t maxBytes);
  /// Waits for the command to end. Unless its exit code is 0, throws UserError with the command's message.
  /// If the command is simreel, usage and device errors keep their exit code. All other errors become
  /// inputOutput.
  void finish();

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  /// Waits for more output and appends it to read_. Returns false at the end of the output.
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
  std::string read_;  ///< output that was read from the command and has not been returned yet
};

}  // namespace simreel::golden

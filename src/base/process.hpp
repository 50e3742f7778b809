#pragma once
#include <string>
#include <sys/types.h>
#include <vector>

namespace simreel {

/// Descriptors that a child process gets as standard input, output and error; -1 stands for /dev/null.
struct ChildStreams {
  int input = -1;
  int output = -1;
  int messages = -1;
};

/// Starts a program found in PATH. arguments[0] is its name. The child leads a new process group, so that
/// Ctrl-C reaches only this process, and has the default action for SIGPIPE. Sets `child` and returns 0, or
/// returns errno.
[[nodiscard]] int startProcess(const std::vector<std::string>& arguments, const ChildStreams& streams,
                               pid_t& child);

/// Forks this process. The child has a new process group and is killed when this process ends. Returns 0 in
/// the child, whose list of children is empty. Returns -1 with errno set on failure. Must be called only
/// while no other thread runs.
[[nodiscard]] pid_t forkProcess();

/// Removes a child from the list of running children. Must be called before the child is reaped, or
/// immediately after.
void childEnded(pid_t child) noexcept;
/// Kills all running children and their process groups. Safe in signal handlers.
void endChildren() noexcept;
/// True if endChildren() has killed a child.
[[nodiscard]] bool childrenWereEnded() noexcept;
/// Returns the processor time of all running children in seconds. Safe in signal handlers.
[[nodiscard]] double childrenSeconds() noexcept;

/// Creates an anonymous file in memory for a child's messages. Unlike a pipe, the file never blocks the
/// child. Returns a descriptor that children do not inherit, or -1 with errno set.
[[nodiscard]] int makeMemoryFile(const char* label);
/// Returns the last 16 KiB of a memory file.
[[nodiscard]] std::string endOfMemoryFile(int descriptor);

/// Returns the word, quoted for /bin/sh if it needs quotes.
[[nodiscard]] std::string inShellQuotes(const std::string& word);

}  // namespace simreel

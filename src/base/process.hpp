#pragma once
#include <string>
#include <sys/types.h>
#include <vector>

namespace simreel {

/// The descriptors that a child gets as its 0, 1 and 2; -1: /dev/null.
struct ChildStreams {
  int input = -1;
  int output = -1;
  int messages = -1;
};

/// Starts a program found along PATH; `arguments` begin with its name. The child leads a process group of
/// its own, so Ctrl-C reaches us alone, and has SIGPIPE's default back. `child` is set where it started.
/// Returns 0, or errno.
[[nodiscard]] int startProcess(const std::vector<std::string>& arguments, const ChildStreams& streams,
                               pid_t& child);

/// A copy of this process, in a process group of its own as well, which is killed when this one ends.
/// Returns 0 in the copy, which knows nothing of the children of this one; -1 with errno set where there is
/// none. Call it while no other thread runs.
[[nodiscard]] pid_t forkProcess();

/// Call before a child is reaped, or right after.
void childEnded(pid_t child) noexcept;
/// Kills every child that has not ended, with its group. For signal handlers, too.
void endChildren() noexcept;
/// Whether endChildren() found one.
[[nodiscard]] bool childrenWereEnded() noexcept;
/// Processor time of the children that run, s. For signal handlers, too.
[[nodiscard]] double childrenSeconds() noexcept;

/// A file without a name, in memory: what a child says goes there, so it never waits for a reader. Returns
/// a descriptor that children do not inherit, or -1 with errno set.
[[nodiscard]] int makeMemoryFile(const char* label);
/// The last 16 KiB of what a memory file holds.
[[nodiscard]] std::string endOfMemoryFile(int descriptor);

/// The word as /bin/sh reads it back: quoted where needed.
[[nodiscard]] std::string inShellQuotes(const std::string& word);

}  // namespace simreel

#pragma once
#include <cstddef>
#include <functional>
#include <string>

namespace simreel {

/// Limits on the resources of isolated work.
struct ProcessLimits {
  std::size_t bytes;  ///< address space in bytes, in addition to what the process already uses
  int seconds;        ///< processor time in seconds
};

/// Runs `work`, which may crash, hang or exhaust the memory, in a child process and returns the result of
/// `work`. Rethrows a UserError of the child. If `work` does not return, throws std::runtime_error with a
/// text that states how the child ended and that can follow a name: "crashed (Segmentation fault)". `work`
/// must neither use a GL context nor wait for another thread, because the child has neither a context nor
/// other threads. If the system cannot start a process, runs `work` in the calling process.
[[nodiscard]] std::string runIsolated(const ProcessLimits& allotment,
                                      const std::function<std::string()>& work);

}  // namespace simreel

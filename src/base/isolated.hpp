#pragma once
#include <cstddef>
#include <functional>
#include <string>

namespace simreel {

/// What isolated work may use up.
struct Allotment {
  std::size_t bytes;  ///< of address space, beside what the process has already
  int seconds;        ///< of processor time
};

/// Runs `work`, which may crash, hang or take all memory, in a child process, and gives what it returns. A
/// UserError crosses over. Throws std::runtime_error saying how it ended where it did not return ("crashed
/// (Segmentation fault)"), to follow a name. `work` must neither use a GL context nor wait for another
/// thread: those stay behind. Where the system gives no further process, the work is done in this one.
[[nodiscard]] std::string runIsolated(const Allotment& allotment, const std::function<std::string()>& work);

}  // namespace simreel

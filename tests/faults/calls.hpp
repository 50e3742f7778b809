#pragma once
#include <cstdint>

namespace faults {

/// What can be made to fail.
enum class Class {
  open,
  read,
  write,
  sync,
  close,
  rename,
  unlink,
  mkdir,
  lock,
  pipe,
  thread,
  process,
  alloc,
  gl,
  egl
};
constexpr const char* classNames[] = {"open",   "read",    "write", "sync", "close",
                                      "rename", "unlink",  "mkdir", "lock", "pipe",
                                      "thread", "process", "alloc", "gl",   "egl"};
constexpr int classes = sizeof classNames / sizeof *classNames;

/// While one lives, its thread is in the driver, whose calls are not ours.
class InDriver {
 public:
  InDriver();
  ~InDriver();
  InDriver(const InDriver&) = delete;
  InDriver& operator=(const InDriver&) = delete;
};

/// Counts a call that came from `caller` and says whether it is the one to fail. Calls of the driver and of
/// other libraries do not count; `libraries`: those that the C++ libraries make on our behalf do.
[[nodiscard]] bool fails(Class what, const char* call, const void* caller, bool libraries);

}  // namespace faults

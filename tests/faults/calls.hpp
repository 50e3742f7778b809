#pragma once
#include <cstdint>

namespace faults {

/// Classes of calls that can be made to fail.
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

/// Marks the current thread as inside the driver while the object exists. Calls by the driver are not
/// counted.
class InDriver {
 public:
  InDriver();
  ~InDriver();
  InDriver(const InDriver&) = delete;
  InDriver& operator=(const InDriver&) = delete;
};

/// Counts a call from the address `caller` and returns true if this call must fail. Does not count calls of
/// the driver and of other libraries. `libraries`: true to count calls that the C++ libraries make for the
/// program.
[[nodiscard]] bool fails(Class what, const char* call, const void* caller, bool libraries);

}  // namespace faults

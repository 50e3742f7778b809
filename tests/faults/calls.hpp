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

/// Marks its thread as inside the driver for its lifetime; the driver's calls are not counted.
class InDriver {
 public:
  InDriver();
  ~InDriver();
  InDriver(const InDriver&) = delete;
  InDriver& operator=(const InDriver&) = delete;
};

/// Counts a call made at `caller` and returns true if this call must fail. Calls of the driver and of other
/// libraries do not count. `libraries`: true if calls by the C++ libraries on the program's behalf count.
[[nodiscard]] bool fails(Class what, const char* call, const void* caller, bool libraries);

}  // namespace faults

// Library that is loaded before simreel (LD_PRELOAD). It makes the Nth call of one class fail, or counts
// the calls of each class.
//
//     FAULTS=write:3          the third write fails; "none": no call fails
//     FAULTS_LOG=FILE         file for the failed call and, at the end, the number of calls of each class
//
// Only calls by simreel's own code are counted. Calls that the driver makes inside a GL call are not
// counted, although the driver's libraries use the same functions of the C++ library as the program.
#include "calls.hpp"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace faults {

namespace {

struct Range {
  std::uintptr_t begin = 0, end = 0;
  [[nodiscard]] bool holds(const void* at) const {
    const auto value = reinterpret_cast<std::uintptr_t>(at);
    return value >= begin && value < end;
  }
};

/// Address ranges of the program and of the C++ libraries, and the call that must fail.
struct Plan {
  Range program, libraries[2];
  bool armed = false;
  int what = -1;
  long which = 0;
  int log = -1;
};
Plan plan;
thread_local int inDriver = 0;
std::atomic<long> counts[classes];

/// Writes to the log with a system call, because this library replaces write().
void say(const char* text) {
  if (plan.log >= 0) (void)::syscall(SYS_write, plan.log, text, std::strlen(text));
}

int visit(dl_phdr_info* info, std::size_t /*size*/, void* data) {
  bool& first = *static_cast<bool*>(data);
  Range* range = nullptr;
  if (first)
    range = &plan.program;
  else if (std::strstr(info->dlpi_name, "libstdc++") != nullptr)
    range = &plan.libraries[0];
  else if (std::strstr(info->dlpi_name, "libtbb.") != nullptr)
    range = &plan.libraries[1];
  first = false;
  if (range == nullptr) return 0;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = info->dlpi_phdr[i];
    if (segment.p_type != PT_LOAD || (segment.p_flags & PF_X) == 0) continue;
    range->begin = info->dlpi_addr + segment.p_vaddr;
    range->end = range->begin + segment.p_memsz;
  }
  return 0;
}

/// Reads the plan from the environment. Does nothing in programs that simreel starts, which inherit the
/// environment.
[[gnu::constructor]] void start() {
  if (std::strcmp(program_invocation_short_name, "simreel") != 0) return;
  const char* wanted = std::getenv("FAULTS");
  if (wanted == nullptr) return;
  if (const char* file = std::getenv("FAULTS_LOG"))
    plan.log = static_cast<int>(
        ::syscall(SYS_openat, AT_FDCWD, file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  if (const char* colon = std::strchr(wanted, ':'))
    for (int i = 0; i < classes; ++i)
      if (std::strncmp(wanted, classNames[i], static_cast<std::size_t>(colon - wanted)) == 0 &&
          classNames[i][colon - wanted] == '\0') {
        plan.what = i;
        plan.which = std::atol(colon + 1);
      }
  bool first = true;
  ::dl_iterate_phdr(visit, &first);
  plan.armed = true;
}

[[gnu::destructor]] void end() {
  if (!plan.armed) return;
  plan.armed = false;
  char line[64];
  for (int i = 0; i < classes; ++i) {
    std::snprintf(line, sizeof line, "count %s %ld\n", classNames[i], counts[i].load());
    say(line);
  }
}

}  // namespace

InDriver::InDriver() {
  ++inDriver;
}

InDriver::~InDriver() {
  --inDriver;
}

bool fails(Class what, const char* call, const void* caller, bool libraries) {
  if (!plan.armed || inDriver > 0) return false;
  const bool ours = plan.program.holds(caller) ||
                    (libraries && (plan.libraries[0].holds(caller) || plan.libraries[1].holds(caller)));
  if (!ours) return false;
  const int index = static_cast<int>(what);
  if (++counts[index] != plan.which || plan.what != index) return false;
  char line[128];
  std::snprintf(line, sizeof line, "failed %s at %#lx\n", call,
                static_cast<unsigned long>(reinterpret_cast<std::uintptr_t>(caller) - plan.program.begin));
  say(line);
  return true;
}

}  // namespace faults

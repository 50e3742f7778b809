#include "cli/stack_room.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cstdlib>
#include <sys/resource.h>
#include <unistd.h>

namespace simreel::cli {

void takeStackRoom(char** arguments) {
  constexpr rlim_t good = rlim_t{8} << 20, enough = rlim_t{1} << 20, minimum = rlim_t{256} << 10;
  constexpr const char* again = "SIMREEL_STACK_TAKEN";
  rlimit room{};
  if (::getrlimit(RLIMIT_STACK, &room) != 0 || room.rlim_cur >= enough) return;
  const rlim_t before = room.rlim_cur;
  // NOLINTNEXTLINE(concurrency-mt-unsafe): no other thread runs yet.
  if (std::getenv(again) == nullptr) {
    // `maximum` raises the soft and the hard limit if that is allowed. `some` raises the soft limit as far
    // as the hard limit permits.
    const rlimit maximum{good, std::max(good, room.rlim_max)},
        some{std::min(good, room.rlim_max), room.rlim_max};
    if (::setrlimit(RLIMIT_STACK, &maximum) != 0) static_cast<void>(::setrlimit(RLIMIT_STACK, &some));
    // The program restarts because the limit at program start determines the size of thread stacks.
    if (::getrlimit(RLIMIT_STACK, &room) == 0 && room.rlim_cur > before) {
      ::setenv(again, "1", 1);  // NOLINT(concurrency-mt-unsafe)
      ::execv("/proc/self/exe", arguments);
    }
  }
  if (room.rlim_cur < minimum)
    fail(ExitCode::device, "the stack may have {} KiB here, and drivers need {}; allow more: ulimit -s {}",
         before >> 10, minimum >> 10, good >> 10);
}

}  // namespace simreel::cli

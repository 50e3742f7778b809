#pragma once
#include <chrono>
#include <ctime>

namespace simreel {

using Clock = std::chrono::steady_clock;

/// Returns the seconds from `begin` to now.
[[nodiscard]] inline double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Returns the CPU time of this process in seconds, which is the user and system time of all threads.
[[nodiscard]] inline double processSeconds() {
  std::timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace simreel

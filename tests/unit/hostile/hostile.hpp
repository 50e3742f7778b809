#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <sys/resource.h>
#include <sys/time.h>

#include <doctest/doctest.h>

/// Helpers for tests with files designed to exhaust memory or time.
namespace simreel::test {

/// Returns the maximum memory so far of this process and its children, in MiB.
inline long peak() {
  rusage own{}, children{};
  ::getrusage(RUSAGE_SELF, &own);
  ::getrusage(RUSAGE_CHILDREN, &children);
  return std::max(own.ru_maxrss, children.ru_maxrss) / 1024;
}

/// Returns the processor time of this process and its children in seconds.
inline double spent() {
  double seconds = 0;
  for (const int processes : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    ::getrusage(processes, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime})
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return seconds;
}

#ifdef SIMREEL_SANITIZED
constexpr bool measured = false;  // Limits are not checked in sanitizer builds, because sanitizers are slow
                                  // and do not free memory immediately.
#else
constexpr bool measured = true;
#endif

/// Returns the message of the error that `read` throws. Checks that `read` takes less than 200 MiB and 40 s
/// of CPU time. The slowest case takes a second, or three on a busy machine. Input that is not refused
/// would take minutes.
inline std::string refusal(const std::function<void()>& read) {
  const long before = peak();
  const double start = spent();
  std::string message = "nothing was refused";
  try {
    read();
  } catch (const std::exception& error) {
    message = error.what();
  }
  if (measured) CHECK(spent() - start < 40);
  if (measured) CHECK(peak() - before < 200);
  return message;
}

inline std::string times(std::size_t count, const std::string& text) {
  std::string all;
  all.reserve(count * text.size());
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

}  // namespace simreel::test

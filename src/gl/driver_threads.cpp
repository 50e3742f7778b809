#include "gl/driver_threads.hpp"

#include "base/log.hpp"
#include "base/processor.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <latch>
#include <malloc.h>
#include <new>
#include <string>
#include <sys/resource.h>
#include <system_error>
#include <thread>
#include <vector>

namespace simreel::gl {

namespace {

std::size_t sharers = 1;

/// Whether so many threads can live at once besides those there are.
bool canStart(std::size_t count) {
  std::vector<std::thread> threads;
  std::latch end(1);
  try {
    threads.reserve(count);
    while (threads.size() < count) threads.emplace_back([&] { end.wait(); });
  } catch (const std::system_error&) {  // NOLINT(bugprone-empty-catch): the count tells.
  } catch (const std::bad_alloc&) {     // NOLINT(bugprone-empty-catch)
  }
  end.count_down();
  for (std::thread& thread : threads) thread.join();
  return threads.size() == count;
}

bool addressSpaceBelow(rlim_t bytes) {
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur < bytes;
}

void setThreads(std::size_t count) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): no other thread is there yet.
  ::setenv("LP_NUM_THREADS", std::to_string(count).c_str(), 0);
}

}  // namespace

void shareProcessors(std::size_t processes) {
  sharers = std::max<std::size_t>(processes, 1);
}

std::size_t processorShare() {
  return std::max<std::size_t>(processorCount() / sharers, 1);
}

std::size_t driverThreads() {
  const char* text =
      std::getenv("LP_NUM_THREADS");  // NOLINT(concurrency-mt-unsafe): nobody sets it meanwhile
  return text == nullptr ? 0 : std::strtoul(text, nullptr, 10);
}

void chooseDriverThreads() {
  // llvmpipe starts so many threads for pictures and so many for kernels, 32 at most; then come ours.
  constexpr std::size_t most = 32;
  const std::size_t processors = std::clamp<std::size_t>(processorCount() / sharers, 1, most);
  const auto needed = [&](std::size_t threads) { return 2 * threads + processors + 4; };
  // Measured: 1.4 GB on 4 processors with a thread each, most of it reserved for threads.
  const bool little = addressSpaceBelow(rlim_t{3} << 30);
  // Each further heap of the C library reserves 128 MB.
  if (little) ::mallopt(M_ARENA_MAX, 1);
  if (little || !canStart(needed(processors))) {
    setThreads(0);
    detail("{}: a software driver works on one thread",
           little ? "little address space (ulimit -v)" : "few threads are to be had");
    return;
  }
  // It hands each thread one equal part of a kernel's work, and all wait for the slowest. With two parts a
  // processor those done first take over; more parts gain little for kernels, and pictures lose.
  // Processes that share them fill each other's gaps; a thread beside the one that waits for it costs one
  // that has a single processor a tenth of its time.
  if (sharers > 1) return setThreads(processors == 1 ? 0 : processors);
  const std::size_t parts = std::min(2 * processors, most);
  const bool room = !addressSpaceBelow(rlim_t{16} << 30) && canStart(needed(parts));
  setThreads(room ? parts : processors);
}

}  // namespace simreel::gl

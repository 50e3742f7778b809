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

/// True if the system can start `count` more threads that run at the same time.
bool canStart(std::size_t count) {
  std::vector<std::thread> threads;
  std::latch end(1);
  try {
    threads.reserve(count);
    while (threads.size() < count) threads.emplace_back([&] { end.wait(); });
  } catch (const std::system_error&) {  // NOLINT(bugprone-empty-catch): threads.size() shows the failure
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
      std::getenv("LP_NUM_THREADS");  // NOLINT(concurrency-mt-unsafe): no other thread sets it
  return text == nullptr ? 0 : std::strtoul(text, nullptr, 10);
}

void chooseDriverThreads() {
  // llvmpipe starts `threads` threads for drawing and the same number for compute, at most 32 each. The
  // program's own threads must be added.
  constexpr std::size_t maximum = 32;
  const std::size_t processors = std::clamp<std::size_t>(processorCount() / sharers, 1, maximum);
  const auto needed = [&](std::size_t threads) { return 2 * threads + processors + 4; };
  // The program reserves 1.4 GB of address space on 4 processors with one driver thread each, most of it
  // for thread stacks.
  const bool little = addressSpaceBelow(rlim_t{3} << 30);
  // Each additional malloc arena of the C library reserves 128 MB.
  if (little) ::mallopt(M_ARENA_MAX, 1);
  if (little || !canStart(needed(processors))) {
    setThreads(0);
    detail("{}: a software driver works on one thread",
           little ? "little address space (ulimit -v)" : "the system allows few threads");
    return;
  }
  // llvmpipe splits the work of a kernel into equal parts, one for each of its threads, and waits for the
  // slowest. With two threads per processor, processors that finish early take over work. More threads help
  // little for kernels and slow down drawing. With several processes (sharers > 1), one thread per
  // processor is enough, because a process runs while another waits. On a single processor, a driver thread
  // next to the waiting main thread costs a tenth of the time, so none is used.
  if (sharers > 1) return setThreads(processors == 1 ? 0 : processors);
  const std::size_t parts = std::min(2 * processors, maximum);
  const bool room = !addressSpaceBelow(rlim_t{16} << 30) && canStart(needed(parts));
  setThreads(room ? parts : processors);
}

}  // namespace simreel::gl

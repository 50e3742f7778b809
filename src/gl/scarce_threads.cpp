#include "gl/scarce_threads.hpp"

#include "base/log.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <latch>
#include <malloc.h>
#include <new>
#include <sys/resource.h>
#include <system_error>
#include <thread>
#include <vector>

namespace simreel::gl {

namespace {

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

bool littleAddressSpace() {
  constexpr rlim_t enough = rlim_t{3}
                            << 30;  // measured: 1.4 GB on 4 cores, most of it reserved for threads
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur < enough;
}

}  // namespace

void allowForScarceThreads() {
  // llvmpipe: one per processor for pictures and one for kernels, 32 at most; then ours.
  const std::size_t processors = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 32);
  const bool little = littleAddressSpace();
  // Each further heap of the C library reserves 128 MB.
  if (little) ::mallopt(M_ARENA_MAX, 1);
  if (!little && canStart(3 * processors + 4)) return;
  ::setenv("LP_NUM_THREADS", "0", 0);  // NOLINT(concurrency-mt-unsafe): no other thread is there yet.
  detail("{}: a software driver works on one thread",
         little ? "little address space (ulimit -v)" : "few threads are to be had");
}

}  // namespace simreel::gl

#pragma once
#include <cstddef>

namespace simreel::gl {

/// Says that so many processes like this one share the processors: each gets an equal part of them, a
/// thread of the driver on each. Call before the first context.
void shareProcessors(std::size_t processes);

/// Processors that this process may use: all of them, or its part of them.
[[nodiscard]] std::size_t processorShare();

/// Threads of a software driver, as $LP_NUM_THREADS says once chooseDriverThreads() has been called: 0 or 1
/// also where the system grants no more, or the user wants a single one.
[[nodiscard]] std::size_t driverThreads();

/// Call before the first context. How many threads a software driver shall use, as $LP_NUM_THREADS, which
/// stays where it is set: two a processor, so that no processor waits for a slower one. Where the
/// system grants few threads or little address space (prlimit --nproc, ulimit -v), one: it would wait for
/// ever for threads that never started, or crash.
void chooseDriverThreads();

}  // namespace simreel::gl

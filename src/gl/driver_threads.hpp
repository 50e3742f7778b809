#pragma once
#include <cstddef>

namespace simreel::gl {

/// Sets the number of processes, this one included, that share the processors. Each process gets an equal
/// share and one driver thread per processor of its share. Call before the first context is created.
void shareProcessors(std::size_t processes);

/// Number of processors that this process may use: all, or its share of them.
[[nodiscard]] std::size_t processorShare();

/// Number of threads of a software driver, read from $LP_NUM_THREADS after chooseDriverThreads(). 0 or 1 if
/// the driver works on a single thread, because of a limit of the system or a setting of the user.
[[nodiscard]] std::size_t driverThreads();

/// Chooses the thread count of a software driver and sets $LP_NUM_THREADS, unless the user has set it. Call
/// before the first context is created. Normally two threads per processor, so that no processor idles
/// while a slower one finishes. If the system allows few threads or little address space (prlimit --nproc,
/// ulimit -v), the driver gets no extra thread: it would wait forever for threads that could not start, or
/// crash.
void chooseDriverThreads();

}  // namespace simreel::gl

#pragma once
#include <cstddef>

namespace simreel::gl {

/// Sets the number of processes that share the processors, including this one. Each process gets an equal
/// number of processors, and one driver thread for each of its processors. Must be called before the first
/// context is created.
void shareProcessors(std::size_t processes);

/// Returns the number of processors that this process may use.
[[nodiscard]] std::size_t processorShare();

/// Returns the number of threads of a software driver, read from $LP_NUM_THREADS after
/// chooseDriverThreads(). The number is 0 or 1 if the driver works on a single thread, because of a system
/// limit or a user's setting.
[[nodiscard]] std::size_t driverThreads();

/// Chooses the thread count of a software driver and sets $LP_NUM_THREADS, unless the user has set it. Must
/// be called before the first context is created. The count is normally two threads per processor, so that
/// no processor idles while a slower one finishes. If the system allows few threads or little address space
/// (prlimit --nproc, ulimit -v), the driver gets no additional thread. Otherwise it would wait forever for
/// threads that could not start, or crash.
void chooseDriverThreads();

}  // namespace simreel::gl

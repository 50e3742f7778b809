#pragma once

namespace simreel::gl {

/// Call before the first context. Where the system grants few threads or little address space (prlimit
/// --nproc, ulimit -v), a software driver would wait for ever for threads that never started, or crash: it
/// is told to work on the calling one then. $LP_NUM_THREADS, where set, stays.
void allowForScarceThreads();

}  // namespace simreel::gl

#include "frame/interrupt.hpp"

#include "base/frame_check.hpp"
#include "base/log.hpp"
#include "base/process.hpp"

#include <atomic>
#include <cerrno>
#include <initializer_list>
#include <signal.h>
#include <time.h>
#include <unistd.h>

namespace simreel::frame {

namespace {

std::atomic<int> arrived = 0;
std::atomic<int> requested = 0;  ///< signal of setInterrupt()
// A signal handler may only use lock-free atomics.
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<double>::is_always_lock_free);

constexpr int childPatience = 3;  ///< seconds without CPU time until the children are ended
constexpr int patience = 10;      ///< seconds without CPU time until the process exits
std::atomic<int> still = 0;       ///< number of consecutive seconds in which the process used no CPU time
std::atomic<double> busyBefore = 0;

/// Returns the CPU time (s) of the process and its children. Even a process that waits for a slow disk or
/// pipe uses some CPU time now and then.
double busy() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9 + childrenSeconds();
}

[[noreturn]] void endNow(int number) {
  endChildren();
  ::_exit(128 + number);
}

/// Handles SIGALRM, which arrives once a second after an interrupting signal.
void onSecond(int /*number*/) {
  const int error = errno;
  const double now = busy();
  still = now - busyBefore.exchange(now) < 0.01 ? still + 1 : 0;
  if (still == childPatience) endChildren();
  if (still >= patience) {
    rawErrorLine("simreel: error: interrupted, and there was no progress for 10 s: ended");
    endNow(arrived);
  }
  ::alarm(1);
  errno = error;
}

void onSignal(int number, siginfo_t* info, void* /*context*/) {
  // The kernel sent SIGXFSZ because a file exceeded the size limit. The signal is ignored, because the
  // write fails with an error anyway.
  if (number == SIGXFSZ && (info->si_code == SI_KERNEL || info->si_pid == ::getpid())) return;
  if (arrived.exchange(number) != 0) endNow(number);
  ::alarm(1);
}

}  // namespace

void catchInterrupts() {
  struct sigaction action {};
  action.sa_flags = SA_RESTART;
  ::sigemptyset(&action.sa_mask);
  action.sa_handler = onSecond;
  ::sigaction(SIGALRM, &action, nullptr);
  action.sa_flags = SA_RESTART | SA_SIGINFO;
  action.sa_sigaction = onSignal;
  for (const int number : {SIGINT, SIGTERM, SIGXFSZ, SIGHUP}) {
    struct sigaction before {};
    ::sigaction(number, nullptr, &before);
    // nohup started the program and has already ignored the signal.
    if (number == SIGHUP && before.sa_handler == SIG_IGN) continue;
    ::sigaction(number, &action, nullptr);
  }
}

int interruptSignal() {
  const int signal = arrived;
  return signal != 0 ? signal : requested.load();
}

void throwIfInterrupted() {
  if (const int signal = interruptSignal()) throw Interrupted{signal};
}

void setInterrupt(int signal) {
  requested = signal;
}

void interruptFrames() {
  setFrameCheck(throwIfInterrupted);
}

void ignoreBrokenPipes() {
  struct sigaction action {};
  action.sa_handler = SIG_IGN;
  ::sigemptyset(&action.sa_mask);
  ::sigaction(SIGPIPE, &action, nullptr);
}

}  // namespace simreel::frame

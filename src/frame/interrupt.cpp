#include "frame/interrupt.hpp"

#include <atomic>
#include <initializer_list>
#include <signal.h>
#include <unistd.h>

namespace simreel::frame {

namespace {

std::atomic<int> arrived = 0;
// A handler may use lock-free atomics only.
static_assert(std::atomic<int>::is_always_lock_free);

void onSignal(int number) {
  if (arrived.exchange(number) != 0) ::_exit(128 + number);
}

}  // namespace

void catchInterrupts() {
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;
  ::sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM}) ::sigaction(number, &action, nullptr);
}

int interruptSignal() {
  return arrived;
}

void ignoreBrokenPipes() {
  struct sigaction action {};
  action.sa_handler = SIG_IGN;
  ::sigemptyset(&action.sa_mask);
  ::sigaction(SIGPIPE, &action, nullptr);
}

}  // namespace simreel::frame

#include "base/process.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <time.h>
#include <unistd.h>

namespace simreel {

namespace {

// Process ids of running children, as atomics because signal handlers read them. Children that exceed this
// number are not tracked.
constexpr std::size_t maxWatched = 264;
std::array<std::atomic<pid_t>, maxWatched> running{};
std::atomic<bool> ended = false;
static_assert(std::atomic<pid_t>::is_always_lock_free);

void watch(pid_t child) {
  for (std::atomic<pid_t>& slot : running) {
    pid_t none = 0;
    if (slot.compare_exchange_strong(none, child)) return;
  }
}

class SpawnSettings {
 public:
  explicit SpawnSettings(const ChildStreams& streams) {
    ::posix_spawn_file_actions_init(&actions_);
    give(streams.input, STDIN_FILENO, O_RDONLY);
    give(streams.output, STDOUT_FILENO, O_WRONLY);
    give(streams.messages, STDERR_FILENO, O_WRONLY);
    ::posix_spawnattr_init(&attributes_);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t pipe;
    ::sigemptyset(&pipe);
    ::sigaddset(&pipe, SIGPIPE);
    ::posix_spawnattr_setsigdefault(&attributes_, &pipe);
  }
  ~SpawnSettings() {
    ::posix_spawnattr_destroy(&attributes_);
    ::posix_spawn_file_actions_destroy(&actions_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  SpawnSettings(SpawnSettings&&) = delete;
  SpawnSettings& operator=(SpawnSettings&&) = delete;
  [[nodiscard]] int spawn(pid_t& child, const char* program, char* const* arguments) const {
    return ::posix_spawnp(&child, program, &actions_, &attributes_, arguments, environ);
  }

 private:
  void give(int descriptor, int as, int mode) {
    if (descriptor >= 0)
      ::posix_spawn_file_actions_adddup2(&actions_, descriptor, as);
    else
      ::posix_spawn_file_actions_addopen(&actions_, as, "/dev/null", mode, 0);
  }

  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

int startProcess(const std::vector<std::string>& arguments, const ChildStreams& streams, pid_t& child) {
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  pid_t started = -1;
  const int error = SpawnSettings(streams).spawn(started, pointers.front(), pointers.data());
  if (error != 0) return error;
  child = started;
  watch(started);
  return 0;
}

pid_t forkProcess() {
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) return child;
  if (child > 0) {
    ::setpgid(child, child);  // Parent and child both call setpgid(), because either may run first.
    watch(child);
    return child;
  }
  ::setpgid(0, 0);
  for (std::atomic<pid_t>& slot : running) slot = 0;
  // The kernel kills this child when the parent ends. Killing does no harm, because finished files of the
  // child are complete. A child without a parent would hold resources that the next run needs.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // The parent ended before prctl() took effect.
  return 0;
}

void childEnded(pid_t child) noexcept {
  for (std::atomic<pid_t>& slot : running) {
    pid_t held = child;
    slot.compare_exchange_strong(held, 0);
  }
}

void endChildren() noexcept {
  for (const std::atomic<pid_t>& slot : running)
    if (const pid_t child = slot; child > 0) {
      ended = true;
      ::kill(-child, SIGKILL);
    }
}

bool childrenWereEnded() noexcept {
  return ended;
}

double childrenSeconds() noexcept {
  double sum = 0;
  for (const std::atomic<pid_t>& slot : running) {
    clockid_t clock{};
    timespec time{};
    if (const pid_t child = slot;
        child > 0 && ::clock_getcpuclockid(child, &clock) == 0 && ::clock_gettime(clock, &time) == 0)
      sum += static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
  }
  return sum;
}

int makeMemoryFile(const char* label) {
  return ::memfd_create(label, MFD_CLOEXEC);
}

std::string endOfMemoryFile(int descriptor) {
  std::string text(1 << 14, '\0');
  const off_t size = ::lseek(descriptor, 0, SEEK_END);
  const off_t from = std::max<off_t>(0, size - static_cast<off_t>(text.size()));
  const ssize_t got = ::pread(descriptor, text.data(), text.size(), from);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, got)));
  return text;
}

std::string inShellQuotes(const std::string& word) {
  const bool plain = word.find_first_not_of(
                         "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                         "-_=./,:+%@") == std::string::npos;
  if (plain && !word.empty()) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace simreel

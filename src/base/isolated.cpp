#include "base/isolated.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <stdexcept>
#include <string_view>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

namespace simreel {

namespace {

#ifdef SIMREEL_SANITIZED
// The limits are off under sanitizers, which reserve terabytes of address space, are slow, and print
// reports.
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

/// First byte of the child's result, which states the outcome.
enum Outcome : char { returned = 'r', mistake = 'u', outOfMemory = 'm', other = 'o' };

/// Anonymous file in memory for the child's result. Unlike a pipe, it need not be read while the child
/// runs.
class ResultFile {
 public:
  ResultFile() : file_(::memfd_create("simreel", MFD_CLOEXEC)) {}
  ~ResultFile() {
    if (file_ >= 0) ::close(file_);
  }
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;
  [[nodiscard]] bool ready() const { return file_ >= 0; }

  bool put(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t done = ::write(file_, bytes.data(), bytes.size());
      if (done < 0 && errno != EINTR) return false;
      if (done > 0) bytes.remove_prefix(static_cast<std::size_t>(done));
    }
    return true;
  }
  [[nodiscard]] std::string readAll() const {
    struct stat status {};
    if (::fstat(file_, &status) != 0) return {};
    std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
    std::size_t have = 0;
    while (have < bytes.size()) {
      const ssize_t got =
          ::pread(file_, bytes.data() + have, bytes.size() - have, static_cast<off_t>(have));
      if (got == 0 || (got < 0 && errno != EINTR)) return {};
      if (got > 0) have += static_cast<std::size_t>(got);
    }
    return bytes;
  }

 private:
  int file_;
};

std::size_t addressSpace() {
  std::size_t pages = 0;
  char text[64] = {};
  const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (file >= 0) {
    if (::read(file, text, sizeof text - 1) > 0) pages = std::strtoul(text, nullptr, 10);
    ::close(file);
  }
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void limit(__rlimit_resource what, rlim_t max) {
  rlimit now{};
  ::getrlimit(what, &now);
  now.rlim_cur = std::min(max, now.rlim_max);
  ::setrlimit(what, &now);
}

void settleIn(const ProcessLimits& allotment) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // Only the parent handles interrupts and reports crashes.
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, SIG_IGN);
  for (const int number : {SIGXCPU, SIGABRT, SIGPIPE}) std::signal(number, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(allotment.seconds) * (sanitized ? 20 : 1));
  if (sanitized) return;
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) std::signal(number, SIG_DFL);
  limit(RLIMIT_AS, addressSpace() + allotment.bytes);
  if (const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) {
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
  }
}

/// Runs the work in the child and exits with _exit(), so that no destructor of a static object runs and no
/// buffer inherited from the parent is written.
[[noreturn]] void runChild(const ResultFile& parcel, const ProcessLimits& allotment,
                           const std::function<std::string()>& work) {
  settleIn(allotment);
  const auto leave = [&](Outcome outcome, std::string_view bytes) {
    const char letter = outcome;
    ::_exit(parcel.put({&letter, 1}) && parcel.put(bytes) ? 0 : 1);
  };
  try {
    leave(returned, work());
  } catch (const UserError& error) {
    leave(mistake, fmt::format("{}{}{}", static_cast<char>(error.code()), static_cast<char>(error.form()),
                               error.what()));
  } catch (const std::bad_alloc&) {
    leave(outOfMemory, {});
  } catch (const std::exception& error) {
    leave(other, error.what());
  } catch (...) {
    leave(other, "unknown reason");
  }
  ::_exit(1);
}

std::string howItEnded(int status, const ProcessLimits& allotment) {
  if (!WIFSIGNALED(status)) return "crashed";
  if (WTERMSIG(status) == SIGXCPU) return fmt::format("took more than {} s", allotment.seconds);
  return fmt::format("crashed ({})", ::strsignal(WTERMSIG(status)));
}

}  // namespace

std::string runIsolated(const ProcessLimits& allotment, const std::function<std::string()>& work) {
  const ResultFile parcel;
  const pid_t child = parcel.ready() ? ::fork() : -1;
  if (child < 0) return work();
  if (child == 0) runChild(parcel, allotment, work);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw std::runtime_error(std::string("was lost: ") + std::strerror(errno));
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error(howItEnded(status, allotment));
  std::string left = parcel.readAll();
  const char outcome = left.empty() ? char{other} : left.front();
  if (!left.empty()) left.erase(0, 1);
  if (outcome == returned) return left;
  if (outcome == mistake && left.size() > 2)
    throw UserError(static_cast<ExitCode>(left[0]), left.substr(2), static_cast<UserError::Form>(left[1]));
  if (outcome == outOfMemory)
    throw std::runtime_error(fmt::format("needs more than {} MiB of memory", allotment.bytes >> 20U));
  throw std::runtime_error("failed: " + left);
}

}  // namespace simreel

#include "golden/bisect/child_command.hpp"

#include "base/error.hpp"
#include "base/process.hpp"
#include "frame/interrupt.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace simreel::golden {

namespace {

constexpr int itemTimeout = 50;  ///< timeout of poll() in ms; needed because a signal may arrive just
                                 ///< before poll()
constexpr std::size_t longestLine = std::size_t{16} << 20;

/// Returns the most informative line of a program's messages. This is the first simreel error, otherwise
/// the first line with "error:", and otherwise the last line.
std::string decisiveLine(const std::string& messages) {
  const std::string own = "simreel: error: ";
  std::string last;
  std::string error;
  for (std::size_t at = 0; at < messages.size();) {
    const std::size_t end = std::min(messages.find('\n', at), messages.size());
    const std::string line = messages.substr(at, end - at);
    at = end + 1;
    if (line.find_first_not_of(" \r\t") == std::string::npos) continue;
    if (line.starts_with(own)) return line.substr(own.size());
    if (error.empty() && line.find("error:") != std::string::npos) error = line;
    last = line;
  }
  return error.empty() ? last : error;
}

}  // namespace

ChildCommand::ChildCommand(const std::string& command, std::string name,
                           const std::vector<std::string>& arguments, double timeout)
    : name_(std::move(name)), timeout_(timeout) {
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0)
    fail(ExitCode::inputOutput, "cannot make a pipe: {}", std::strerror(errno));
  output_ = ends[0];
  messages_ = makeMemoryFile("simreel-child");
  std::vector<std::string> words = {"/bin/sh", "-c", command, "sh"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const int error =
      messages_ < 0
          ? errno
          : startProcess(words, {.input = -1, .output = ends[1], .messages = messages_}, process_);
  ::close(ends[1]);
  if (error == 0) return;
  end();
  fail(ExitCode::inputOutput, "cannot start {}: {}", name_, std::strerror(error));
}

ChildCommand::~ChildCommand() {
  end();
}

void ChildCommand::end() noexcept {
  if (process_ > 0) {
    // Kills the whole process group, because the shell may have started the program as a child.
    ::kill(-process_, SIGKILL);
    childEnded(process_);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  process_ = -1;
  for (int* descriptor : {&output_, &messages_}) {
    if (*descriptor >= 0) ::close(*descriptor);
    *descriptor = -1;
  }
}

void ChildCommand::checkTime() {
  frame::throwIfInterrupted();
  if (timeout_ <= 0 || secondsSince(began_) < timeout_) return;
  const std::string message = decisiveLine(endOfMemoryFile(messages_));
  end();
  fail(ExitCode::inputOutput, "{} took longer than {:g} s (--timeout) and was ended{}{}", name_, timeout_,
       message.empty() ? "" : ": ", message);
}

bool ChildCommand::more() {
  for (;;) {
    checkTime();
    pollfd wait{output_, POLLIN, 0};
    const int ready = ::poll(&wait, 1, itemTimeout);
    if (ready < 0 && errno != EINTR)
      fail(ExitCode::inputOutput, "cannot read from {}: {}", name_, std::strerror(errno));
    if (ready <= 0) continue;
    char block[1 << 16];
    const ssize_t got = ::read(output_, block, sizeof block);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(ExitCode::inputOutput, "cannot read from {}: {}", name_, std::strerror(errno));
    read_.append(block, static_cast<std::size_t>(got));
    return got > 0;
  }
}

std::optional<std::string> ChildCommand::line() {
  std::size_t looked = 0;
  for (;;) {
    const std::size_t end = read_.find('\n', looked);
    if (end != std::string::npos) {
      std::string line = read_.substr(0, end);
      read_.erase(0, end + 1);
      return line;
    }
    looked = read_.size();
    if (looked > longestLine)
      fail(ExitCode::inputOutput, "{} prints no trace: its output has no line ends", name_);
    if (more()) continue;
    if (read_.empty()) return std::nullopt;
    return std::exchange(read_, {});
  }
}

std::vector<std::byte> ChildCommand::rest(std::size_t maxBytes) {
  while (more())
    if (read_.size() > maxBytes)
      fail(ExitCode::inputOutput, "{} prints more than the {} bytes that the state has", name_, maxBytes);
  std::vector<std::byte> bytes(read_.size());
  if (!bytes.empty()) std::memcpy(bytes.data(), read_.data(), bytes.size());
  read_.clear();
  return bytes;
}

void ChildCommand::finish() {
  int status = 0;
  for (;;) {
    checkTime();
    const pid_t ended = ::waitpid(process_, &status, WNOHANG);
    if (ended == process_ || (ended < 0 && errno != EINTR)) break;
    ::usleep(2000);
  }
  childEnded(process_);
  process_ = -1;
  if (status != 0) failed(status);
}

void ChildCommand::failed(int status) {
  const std::string message = decisiveLine(endOfMemoryFile(messages_));
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  const std::string how = WIFSIGNALED(status) ? fmt::format("ended by signal {}", WTERMSIG(status))
                                              : fmt::format("ended with status {}", code);
  const ExitCode ours =
      code == static_cast<int>(ExitCode::usage) || code == static_cast<int>(ExitCode::device)
          ? static_cast<ExitCode>(code)
          : ExitCode::inputOutput;
  fail(ours, "{} {}{}{}", name_, how, message.empty() ? "" : ": ", message);
}

}  // namespace simreel::golden

#include "serve/child/child_process.hpp"

#include "base/error.hpp"
#include "base/process.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <sys/wait.h>
#include <unistd.h>

namespace simreel::serve {

ChildProcess::~ChildProcess() {
  if (running()) {
    ::kill(-process_, SIGTERM);
    childEnded(process_);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  close();
}

void ChildProcess::close() {
  for (int* file : {&output_, &messages_}) {
    if (*file >= 0) ::close(*file);
    *file = -1;
  }
  process_ = 0;
}

void ChildProcess::start(const std::vector<std::string>& arguments) {
  SIMREEL_CHECK(!running());
  close();
  std::vector<std::string> words = {std::filesystem::read_symlink("/proc/self/exe").string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  int error = 0;
  for (int* file : {&output_, &messages_}) {
    *file = makeMemoryFile("simreel");
    if (*file < 0) error = errno;
  }
  ChildStreams streams;
  streams.output = output_;
  streams.messages = messages_;
  if (error == 0) error = startProcess(words, streams, process_);
  if (error == 0) return;
  close();
  fail(ExitCode::inputOutput, "cannot start simreel {}: {}", arguments.front(), std::strerror(error));
}

std::optional<int> ChildProcess::ended() {
  int status = 0;
  if (!running() || ::waitpid(process_, &status, WNOHANG) != process_) return std::nullopt;
  childEnded(process_);
  process_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string ChildProcess::output() const {
  return output_ < 0 ? "" : endOfMemoryFile(output_);
}

std::string ChildProcess::messages() const {
  return messages_ < 0 ? "" : endOfMemoryFile(messages_);
}

}  // namespace simreel::serve

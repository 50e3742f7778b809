#include "serve/play/render_child.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "base/strict_json.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include <nlohmann/json.hpp>

namespace simreel::serve {

RenderChild::~RenderChild() {
  if (process_ > 0) {
    ::kill(-process_, SIGTERM);
    childEnded(process_);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  close();
}

void RenderChild::close() {
  if (messages_ >= 0) ::close(messages_);
  messages_ = -1;
  process_ = 0;
}

void RenderChild::start(std::vector<std::string> arguments, const std::string& frames,
                        const std::filesystem::path& output) {
  if (process_ > 0) fail(ExitCode::usage, "a render is under way already; wait for it");
  makeFolders(output.parent_path());
  std::vector<std::string> words = {std::filesystem::read_symlink("/proc/self/exe").string(), "render"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.insert(words.end(), {"--frames", frames, "--output", output.string(), "--overwrite", "--progress",
                             "ndjson", "--no-counts"});
  messages_ = makeMemoryFile("render");
  ChildStreams streams;
  streams.messages = messages_;
  const int error = messages_ < 0 ? errno : startProcess(words, streams, process_);
  if (error != 0) {
    close();
    fail(ExitCode::inputOutput, "cannot start simreel render: {}", std::strerror(error));
  }
  picture_ = output.has_extension();
  progress_ = {Progress::State::running, 0, 0, output.string(), ""};
}

RenderChild::Progress RenderChild::look() {
  if (process_ <= 0) return progress_;
  int status = 0;
  const bool ended = ::waitpid(process_, &status, WNOHANG) == process_;
  std::istringstream lines(endOfMemoryFile(messages_));
  for (std::string line; std::getline(lines, line);) {
    if (!nlohmann::json::accept(line)) continue;  // the first one may have lost its beginning
    const auto event = nlohmann::json::parse(line);
    if (event.value("event", "") == "start") progress_.total = event.value("frames", 0);
    if (event.value("event", "") == "frame") {
      progress_.done = event.value("done", 0);
      progress_.total = event.value("total", 0);
    }
    if (event.value("level", "") == "error") progress_.text = event.value("text", "");
  }
  if (!ended) return progress_;
  childEnded(process_);
  const bool good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  progress_.state = good ? Progress::State::done : Progress::State::failed;
  close();
  return progress_;
}

}  // namespace simreel::serve

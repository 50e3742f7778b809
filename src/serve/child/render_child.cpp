#include "serve/child/render_child.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"

#include <optional>
#include <sstream>
#include <utility>

#include <nlohmann/json.hpp>

namespace simreel::serve {

void RenderChild::start(std::vector<std::string> arguments, const std::string& frames,
                        const std::filesystem::path& output) {
  if (child_.running()) fail(ExitCode::usage, "another render is running; wait until it ends");
  makeFolders(output.parent_path());
  std::vector<std::string> words = {"render"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.insert(words.end(), {"--frames", frames, "--output", output.string(), "--overwrite", "--progress",
                             "ndjson", "--no-counts"});
  child_.start(words);
  picture_ = output.has_extension();
  progress_ = {Progress::State::running, 0, 0, output.string(), ""};
}

RenderChild::Progress RenderChild::look() {
  if (!child_.running()) return progress_;
  const std::optional<int> ended = child_.ended();
  std::istringstream lines(child_.messages());
  for (std::string line; std::getline(lines, line);) {
    if (!nlohmann::json::accept(line)) continue;  // The first line may be incomplete.
    const auto event = nlohmann::json::parse(line);
    if (event.value("event", "") == "start") progress_.total = event.value("frames", 0);
    if (event.value("event", "") == "frame") {
      progress_.done = event.value("done", 0);
      progress_.total = event.value("total", 0);
    }
    if (event.value("level", "") == "error") progress_.text = event.value("text", "");
  }
  if (ended) progress_.state = *ended == 0 ? Progress::State::done : Progress::State::failed;
  return progress_;
}

}  // namespace simreel::serve

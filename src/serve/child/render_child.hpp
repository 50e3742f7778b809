#pragma once
#include "serve/child/child_process.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace simreel::serve {

/// `simreel render` as a process of its own, which goes on while pictures are shown.
class RenderChild {
 public:
  struct Progress {
    enum class State { none, running, done, failed };
    State state = State::none;
    int done = 0, total = 0;  ///< frames
    std::string output;       ///< picture or folder
    std::string text;         ///< of one that failed: what it said last
    bool operator==(const Progress&) const = default;
  };

  /// `arguments` of `simreel render`, without output, frames and progress. One at a time: throws
  /// UserError(usage) while one runs, and inputOutput where none can be started.
  void start(std::vector<std::string> arguments, const std::string& frames,
             const std::filesystem::path& output);
  [[nodiscard]] Progress look();
  /// Whether it makes one picture, whose file is Progress::output.
  [[nodiscard]] bool isPicture() const { return picture_; }

 private:
  ChildProcess child_;
  bool picture_ = false;
  Progress progress_;
};

}  // namespace simreel::serve

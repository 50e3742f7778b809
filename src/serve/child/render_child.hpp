#pragma once
#include "serve/child/child_process.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace simreel::serve {

/// Runs `simreel render` as another process while pictures are shown.
class RenderChild {
 public:
  struct Progress {
    enum class State { none, running, done, failed };
    State state = State::none;
    int done = 0, total = 0;  ///< number of rendered frames, and total number of frames
    std::string output;       ///< path of the picture or folder
    std::string text;         ///< last error message of a failed render
    bool operator==(const Progress&) const = default;
  };

  /// Starts a render. `arguments`: arguments of `simreel render` except output, frames and progress. Throws
  /// UserError(usage) while another render runs, and UserError(inputOutput) if the process cannot be
  /// started.
  void start(std::vector<std::string> arguments, const std::string& frames,
             const std::filesystem::path& output);
  [[nodiscard]] Progress look();
  /// True if the process renders a single picture, to the file Progress::output.
  [[nodiscard]] bool isPicture() const { return picture_; }

 private:
  ChildProcess child_;
  bool picture_ = false;
  Progress progress_;
};

}  // namespace simreel::serve

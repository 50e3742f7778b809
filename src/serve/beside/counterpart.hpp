#pragma once
#include "frame/image.hpp"
#include "serve/script/script.hpp"
#include "serve/stage/stage.hpp"
#include "sim/core/numerics.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simreel::serve {

/// Settings of the right side: another scene, or the same scene with other values.
struct CounterpartOptions {
  SceneSource source;
  bool ownFile = false;                ///< true: the right side has its own scene file
  bool on = false;                     ///< true: the right side is shown from the start
  std::vector<scene::Override> edits;  ///< overrides that only the right side has
  std::vector<std::string> arguments;  ///< scene and options as command-line arguments
};

/// The right side: a second scene at the same frame as the left one, drawn at the same time.
class Counterpart {
 public:
  explicit Counterpart(CounterpartOptions options) : options_(std::move(options)), on_(options_.on) {}

  [[nodiscard]] bool on() const { return on_; }
  void turn(bool on);
  [[nodiscard]] bool ownFile() const { return options_.ownFile; }
  [[nodiscard]] const CounterpartOptions& options() const { return options_; }
  /// Returns the stage; null if the side is off, or if no version of its scene has been free of errors
  /// since it was turned on.
  [[nodiscard]] Stage* stage() const { return stage_.get(); }
  [[nodiscard]] bool carried() const { return stage_ != nullptr && stage_->carried(); }
  [[nodiscard]] const std::string& mistakes() const { return mistakes_; }
  /// Returns the changes that only this side has, relative to the left scene or to its own file.
  [[nodiscard]] const std::vector<scene::Override>& edits() const { return options_.edits; }
  /// True if the own changes affect the camera's position or target.
  [[nodiscard]] bool hasOwnView() const;
  void setEdits(std::vector<scene::Override> edits) { options_.edits = std::move(edits); }

  /// Updates this side to match `scene`. On an error, keeps the last good version and sets mistakes(). A
  /// new stage starts from a state of `scene` if both have the same states up to there. Returns true if the
  /// state was carried over from other values (Stage::become).
  bool update(const Stage& scene, const sim::Numerics& numerics, std::size_t memory, bool moving,
              int frame);
  void readFile();
  /// Returns the reason why its own file could not be read, or an empty text.
  [[nodiscard]] const std::string& unreadable() const { return unreadable_; }
  /// True if errors in its file, or missing files that it names, have been fixed meanwhile.
  [[nodiscard]] bool isBetter(const Stage& scene) const;
  /// Returns the text of its own file as it was last read.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Sets the text after its own file has been written.
  void setText(std::string text) { text_ = std::move(text); }

 private:
  [[nodiscard]] std::shared_ptr<Script> scriptBeside(const Stage& scene) const;

  CounterpartOptions options_;
  bool on_;
  std::string text_;  ///< text of its own file
  std::string unreadable_;
  std::string mistakes_;
  bool unread_ = false;  ///< true if mistakes_ are errors in the text, or missing files
  std::unique_ptr<Stage> stage_;
};

/// Returns the number of pixels that differ between two pictures of the same size.
[[nodiscard]] std::size_t differingPixels(const frame::Image& a, const frame::Image& b);

}  // namespace simreel::serve

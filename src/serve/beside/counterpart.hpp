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

/// Settings of the right side, which shows another scene, or the same scene with other values.
struct CounterpartOptions {
  SceneSource source;
  bool ownFile = false;                ///< true if the right side has its own scene file
  bool on = false;                     ///< true if the right side is shown from the start
  std::vector<scene::Override> edits;  ///< overrides that apply only to the right side
  std::vector<std::string> arguments;  ///< scene and options as command-line arguments
};

/// The right side. It shows a second scene at the same frame as the left side, drawn at the same time.
class Counterpart {
 public:
  explicit Counterpart(CounterpartOptions options) : options_(std::move(options)), on_(options_.on) {}

  [[nodiscard]] bool on() const { return on_; }
  void turn(bool on);
  [[nodiscard]] bool ownFile() const { return options_.ownFile; }
  [[nodiscard]] const CounterpartOptions& options() const { return options_; }
  /// Returns the stage. Returns null if the side is off, or if the scene has had errors ever since the side
  /// was turned on.
  [[nodiscard]] Stage* stage() const { return stage_.get(); }
  [[nodiscard]] bool carried() const { return stage_ != nullptr && stage_->carried(); }
  [[nodiscard]] const std::string& mistakes() const { return mistakes_; }
  /// Returns the changes that only this side has, relative to the left scene or to this side's scene file.
  [[nodiscard]] const std::vector<scene::Override>& edits() const { return options_.edits; }
  /// True if the changes of this side affect the camera's position or target.
  [[nodiscard]] bool hasOwnView() const;
  void setEdits(std::vector<scene::Override> edits) { options_.edits = std::move(edits); }

  /// Updates this side to match `scene`, the left side. On an error, keeps the last version without errors
  /// and sets mistakes(). A new stage starts from a state of the left side if both sides have equal states
  /// up to that state. Returns true if the state was carried over from a simulation with other values
  /// (Stage::become).
  bool update(const Stage& scene, const sim::Numerics& numerics, std::size_t memory, bool moving,
              int frame);
  void readFile();
  /// Returns the reason why this side's own file could not be read, or an empty text.
  [[nodiscard]] const std::string& unreadable() const { return unreadable_; }
  /// True if errors in this side's file have been fixed, or files that were missing now exist.
  [[nodiscard]] bool isBetter(const Stage& scene) const;
  /// Returns the text of this side's own file as it was last read.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Sets the text after this side's own file has been written.
  void setText(std::string text) { text_ = std::move(text); }

 private:
  [[nodiscard]] std::shared_ptr<Script> scriptBeside(const Stage& scene) const;

  CounterpartOptions options_;
  bool on_;
  std::string text_;  ///< text of this side's own file
  std::string unreadable_;
  std::string mistakes_;
  bool unread_ = false;  ///< true if mistakes_ contains errors in the text or missing files
  std::unique_ptr<Stage> stage_;
};

/// Returns the number of pixels that differ between two pictures of the same size.
[[nodiscard]] std::size_t differingPixels(const frame::Image& a, const frame::Image& b);

}  // namespace simreel::serve

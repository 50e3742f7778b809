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

/// What stands beside the scene: another scene, or the same with other values.
struct CounterpartOptions {
  SceneSource source;
  bool ownFile = false;                ///< whether that is another scene's
  bool on = false;                     ///< from the start
  std::vector<scene::Override> edits;  ///< its values alone
  std::vector<std::string> arguments;  ///< as words of a command line
};

/// The other side: at the frame of the scene, drawn when it is.
class Counterpart {
 public:
  explicit Counterpart(CounterpartOptions options) : options_(std::move(options)), on_(options_.on) {}

  [[nodiscard]] bool on() const { return on_; }
  void turn(bool on);
  [[nodiscard]] bool ownFile() const { return options_.ownFile; }
  [[nodiscard]] const CounterpartOptions& options() const { return options_; }
  /// Null: it is off, or there was never anything right to show.
  [[nodiscard]] Stage* stage() const { return stage_.get(); }
  [[nodiscard]] bool carried() const { return stage_ != nullptr && stage_->carried(); }
  [[nodiscard]] const std::string& mistakes() const { return mistakes_; }
  /// What it has beyond the scene, or its own file.
  [[nodiscard]] const std::vector<scene::Override>& edits() const { return options_.edits; }
  /// Whether one of them is of where the camera stands or what it looks at.
  [[nodiscard]] bool hasOwnView() const;
  void setEdits(std::vector<scene::Override> edits) { options_.edits = std::move(edits); }

  /// Shows what it is beside `scene` now, or keeps what it has shown and says in mistakes() why. Begins
  /// where that one's states are its own, too. Whether its state is one of other values (Stage::become).
  bool show(const Stage& scene, const sim::Numerics& numerics, std::size_t memory, bool moving, int frame);
  void readFile();
  /// Why its own file could not be read, or nothing.
  [[nodiscard]] const std::string& unreadable() const { return unreadable_; }
  /// Whether what was wrong in it, or with files that it names, is so no longer.
  [[nodiscard]] bool isBetter(const Stage& scene) const;
  /// Of its own file, as it was last read.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// That file has this text now.
  void setText(std::string text) { text_ = std::move(text); }

 private:
  [[nodiscard]] std::shared_ptr<Script> scriptBeside(const Stage& scene) const;

  CounterpartOptions options_;
  bool on_;
  std::string text_;  ///< of its own file
  std::string unreadable_;
  std::string mistakes_;
  bool unread_ = false;  ///< whether they are of the text, or of files that are not there
  std::unique_ptr<Stage> stage_;
};

/// Pixels that are not the same in two pictures of one size.
[[nodiscard]] std::size_t differingPixels(const frame::Image& a, const frame::Image& b);

}  // namespace simreel::serve

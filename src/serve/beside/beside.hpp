#pragma once
#include "gl/context.hpp"
#include "golden/suite/judge.hpp"
#include "serve/child/child_process.hpp"
#include "serve/net/hub.hpp"
#include "serve/script/script.hpp"
#include "serve/stage/stage.hpp"
#include "sim/core/numerics.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace simreel::serve {

/// Compares the shown frame with its golden baseline. Draws the frame at the test's size and judges it like
/// `simreel test`.
class Beside {
 public:
  /// `edit`: true if the page may write baselines and the list of tested frames.
  Beside(SceneSource source, bool edit, const gl::Context& context, const sim::Numerics& numerics,
         Hub& hub);

  [[nodiscard]] bool on() const { return on_; }
  void turn(bool on);
  /// Selects the scene whose baselines are used. `right`: true for the scene of the right side.
  void choose(SceneSource source, bool right);
  [[nodiscard]] bool right() const { return right_; }
  /// Draws and judges the stage's frame and sends the result to the viewers. The stage must not have a
  /// state that was carried over from other values (Stage::carried).
  void look(Stage& stage);

  /// Starts `simreel test --update`, which makes the pictures of the scene file the baseline. Throws
  /// UserError(usage) without --edit, if shown values differ from the file, or while another update runs.
  void accept(std::span<const scene::Override> edits);
  /// Returns true once, after the process of accept() has ended.
  bool hasAccepted();

  /// Returns a change of "test.frames" that adds the frame. Throws UserError(usage) if the frame is already
  /// tested, or if the test is in the sidecar.
  [[nodiscard]] scene::Override withFrame(Stage& stage, int frame) const;

  /// Returns the files, in addition to the scene, on which the verdict depends. These are the sidecar and
  /// the baselines.
  [[nodiscard]] std::vector<std::filesystem::path> files() const;

 private:
  void draw(Stage& stage, nlohmann::ordered_json& message);
  [[nodiscard]] golden::Reference reference(const scene::Scene& scene);
  void tell();

  SceneSource source_;
  bool edit_;
  const gl::Context& context_;
  const sim::Numerics& numerics_;
  Hub& hub_;
  bool on_ = false;
  bool right_ = false;
  std::optional<golden::Origin> driver_;  ///< origin of the driver's pictures; computed when first needed
  std::uint64_t pictures_ = 0;
  std::string verdict_;  ///< latest verdict as JSON
  ChildProcess accepting_;
  std::string accepted_ = "none";  ///< state of the latest accept(): "none", "running", "done" or "failed"
  std::string said_;               ///< output of the latest accept()
};

}  // namespace simreel::serve

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

/// The shown frame beside its golden baseline: drawn at the test's size, judged as `simreel test` judges
/// it.
class Beside {
 public:
  /// `edit`: whether baselines and the list of tested frames may be written.
  Beside(SceneSource source, bool edit, const gl::Context& context, const sim::Numerics& numerics,
         Hub& hub);

  [[nodiscard]] bool on() const { return on_; }
  void turn(bool on);
  /// Whose baselines they are from now on; `right`: those of the other side.
  void choose(SceneSource source, bool right);
  [[nodiscard]] bool right() const { return right_; }
  /// Draws the stage's frame, which has to be the script's own, and tells viewers how it came out.
  void look(Stage& stage);

  /// Has `simreel test --update` make what the scene file draws its baseline. Throws UserError(usage) where
  /// it may not: without --edit, with values that the file does not have, while another one runs.
  void accept(std::span<const scene::Override> edits);
  /// Whether accept() has just come to its end.
  bool hasAccepted();

  /// "test.frames" with the frame among them. Throws UserError(usage) where it is there already, or the
  /// test stands beside the scene.
  [[nodiscard]] scene::Override withFrame(Stage& stage, int frame) const;

  /// What the verdict depends on beside the scene: the test beside it, and baselines.
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
  std::optional<golden::Origin> driver_;  ///< of what the driver draws; found out when it is asked for
  std::uint64_t pictures_ = 0;
  std::string verdict_;  ///< JSON of the latest look
  ChildProcess accepting_;
  std::string accepted_ = "none";  ///< "running", "done", "failed"
  std::string said_;               ///< by the latest accept
};

}  // namespace simreel::serve

#pragma once
#include "frame/sink/sequence.hpp"
#include "golden/result.hpp"
#include "golden/suite/check.hpp"
#include "scene/scene.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simreel::batch {

/// Quantity measured by one object at one frame.
struct MeasuredQuantity {
  std::string what;  ///< name of quantity and object: "energy of flag"
  std::string unit;
  int frame = 0;
  std::optional<double> value;  ///< measured number; nullopt if it is infinite or NaN
};

/// Files with results of checks. An empty path means no file.
struct CheckFiles {
  std::filesystem::path
      earlier;  ///< results of an earlier run from whose checkpoint this run continues; need not exist
  std::filesystem::path kept;  ///< file for the results so far, which a later run reads
};

/// Evaluates a scene's checks while it is rendered, and measures all quantities at the last frame.
class Measurements final : public frame::FrameWatch {
 public:
  /// Checks for which the scene gives no frames are evaluated at the tested frames that are drawn and, if
  /// `ends` is true, at the last frame. Frames after the last one are not evaluated. Removes frames without
  /// a picture from the "not-blank" checks of `scene`, which must outlive this object. `onResult`: called
  /// with each new result, but not with results of an earlier run.
  Measurements(scene::Scene& scene, std::span<const int> drawn, CheckFiles files,
               std::function<void(const golden::CheckResult&)> onResult = {}, bool ends = true);

  void begin(const sim::World& world) override;
  [[nodiscard]] bool wants(int frame) const override;
  void made(const sim::World& world) override;
  void drawn(int frame, const frame::Image& image) override;

  /// Evaluates pictures that exist from an earlier attempt. Must be called after the run. `fileOf`: returns
  /// the file of a frame. Throws UserError if a picture cannot be read.
  void evaluateExisting(const std::function<std::filesystem::path(int frame)>& fileOf);

  [[nodiscard]] std::vector<golden::CheckResult> checks() const;
  [[nodiscard]] const std::vector<MeasuredQuantity>& quantities() const { return quantities_; }

 private:
  void news();

  const scene::Scene& scene_;
  std::vector<int> tested_;  ///< frames that are both drawn and compared
  std::vector<int> wanted_;  ///< frames whose state is needed, ascending
  CheckFiles files_;
  std::function<void(const golden::CheckResult&)> onResult_;
  std::optional<golden::Checker> checker_;
  std::set<int> drawn_;  ///< tested frames that have been drawn
  std::size_t reportedCount_ = 0;
  std::set<std::pair<int, std::string>> reported_;
  std::vector<MeasuredQuantity> quantities_;
};

}  // namespace simreel::batch

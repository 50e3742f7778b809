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

/// What one object measures, at one frame.
struct MeasuredQuantity {
  std::string what;  ///< "energy of flag"
  std::string unit;
  int frame = 0;
  std::optional<double> value;  ///< nothing where it is no finite number
};

/// Where results of checks lie; empty: nowhere.
struct CheckFiles {
  std::filesystem::path
      earlier;  ///< of a run before this one, which goes on from its checkpoint; may be missing
  std::filesystem::path kept;  ///< those so far, for a run after this one
};

/// Evaluates a scene's checks while it is rendered, and measures every quantity at the last frame.
class Measurements final : public frame::FrameWatch {
 public:
  /// Checks without frames of their own are made at the frames that a test compares, as far as they are
  /// drawn, and (`ends`) at the last one; those of frames beyond the last are not made. The scene, from
  /// whose checks "not-blank" of frames without picture are taken, has to live longer. `hear`: each result
  /// as it comes, but for those of an earlier run.
  Measurements(scene::Scene& scene, std::span<const int> drawn, CheckFiles files,
               std::function<void(const golden::CheckResult&)> hear = {}, bool ends = true);

  void begin(const sim::World& world) override;
  [[nodiscard]] bool wants(int frame) const override;
  void made(const sim::World& world) override;
  void drawn(int frame, const frame::Image& image) override;

  /// Once the run is over: pictures that it kept from an earlier attempt are looked at where they lie.
  /// Throws UserError where one cannot be read.
  void lookAtKept(const std::function<std::filesystem::path(int frame)>& fileOf);

  [[nodiscard]] std::vector<golden::CheckResult> checks() const;
  [[nodiscard]] const std::vector<MeasuredQuantity>& quantities() const { return quantities_; }

 private:
  void news();

  const scene::Scene& scene_;
  std::vector<int> tested_;  ///< frames that are drawn and compared
  std::vector<int> wanted_;  ///< ascending
  CheckFiles files_;
  std::function<void(const golden::CheckResult&)> hear_;
  std::optional<golden::Checker> checker_;
  std::set<int> drawn_;  ///< of the tested ones
  std::size_t heard_ = 0;
  std::set<std::pair<int, std::string>> told_;
  std::vector<MeasuredQuantity> quantities_;
};

}  // namespace simreel::batch

#pragma once
#include "golden/baseline/baseline.hpp"
#include "golden/compare/compare.hpp"
#include "golden/result.hpp"
#include "golden/suite/scene_run.hpp"
#include "golden/trace/passes.hpp"
#include "scene/scene.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace simreel::golden {

/// Baselines and settings with which a run is compared.
struct Reference {
  std::filesystem::path folder;             ///< folder of the scene's baselines
  std::optional<PictureBaseline> pictures;  ///< picture baseline; empty if the scene has no baseline
  std::optional<StateBaseline> state;
  /// true if the scene's numerics are exact; `here` contains whether the pictures are exact
  bool exact = true;
  Origin here;                 ///< origin of this run's pictures
  scene::Tolerance tolerance;  ///< tolerance that applies if a driver drew the pictures and the
                               ///< fingerprints differ
};

/// Reads the existing baselines of a scene. Throws UserError(inputOutput) if they are unusable.
[[nodiscard]] Reference findReference(const std::filesystem::path& folder, const std::string& ownProfile,
                                      bool exact, const Origin& here);

struct Judgement {
  FrameResult frame;
  bool pictureFails = false;  ///< true if the picture differs or its baseline is unusable
  bool damaged = false;       ///< true if the picture's baseline is unusable
};

/// Judges one frame by these rules, in this order. There must be a baseline. The state must be equal
/// (always with exact numerics; with fast numerics if the numerics fingerprints are equal). The sizes must
/// be equal. A picture with an equal pixel hash passes. Otherwise the frame fails if one of the pictures is
/// exact or if this machine drew the baseline. On another machine with equal fingerprints, the picture must
/// be within brokenNearness(). In all other cases, all bounds of the tolerance must hold. Accepted
/// alternates count like the baseline. Fills in the metrics of differing pictures, and leaves image paths
/// empty. Always reads the baseline's pictures and verifies their listed hashes. Quick measures omit SSIM
/// and FLIP, unless a rule needs FLIP.
[[nodiscard]] Judgement judgeFrame(const RunFrame& made, const Reference& reference,
                                   Measures measures = Measures::all);

/// Returns the picture that judgeFrame compared with the frame. `alternate` is as in
/// FrameResult::alternate. Throws UserError(inputOutput).
[[nodiscard]] frame::Image referencePicture(const Reference& reference, int frame, int alternate);

/// Returns the first pass and pixel at which a picture differs from its baseline. `drawn`: outputs of the
/// picture's passes. Returns nothing if they are equal or if the baseline's picture is unusable.
[[nodiscard]] std::optional<PassPlace> placeOfDifference(const Reference& reference, const RunFrame& made,
                                                         int alternate, const PassDump& drawn);

/// Returns a message for each bound that is more than 10 times the largest observed value: "maxDiffRatio is
/// 0.02, 50 times the 0.0004 observed".
[[nodiscard]] std::vector<std::string> looseBounds(const std::vector<FrameResult>& frames,
                                                   const scene::Tolerance& tolerance);

}  // namespace simreel::golden

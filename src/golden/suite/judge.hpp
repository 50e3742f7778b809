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

/// What a run is held against.
struct Reference {
  std::filesystem::path folder;             ///< of the scene's baselines
  std::optional<PictureBaseline> pictures;  ///< nothing: missing
  std::optional<StateBaseline> state;
  bool exact = true;           ///< the scene's numerics; of its pictures see `here`
  Origin here;                 ///< of this run's pictures
  scene::Tolerance tolerance;  ///< in force where a driver drew and the fingerprints differ
};

/// Reads what there is for the scene. Throws UserError(inputOutput) where it cannot be used.
[[nodiscard]] Reference findReference(const std::filesystem::path& folder, const std::string& ownProfile,
                                      bool exact, const Origin& here);

struct Judgement {
  FrameResult frame;
  bool pictureFails = false;  ///< differs, or its baseline cannot be used
  bool damaged = false;       ///< its baseline cannot be used
};

/// The verdict on one frame, in this order: a baseline must be there, state must be equal (always in exact
/// numerics; between equal numerics fingerprints in fast numerics), sizes must be equal, equal pixel hashes
/// pass; then the frame fails where one of the two was drawn exactly and on the machine that drew the
/// baseline; on another one with its fingerprints it has to be near (brokenNearness), and everywhere every
/// bound of the tolerance must hold. Alternates count as the baseline does. Fills the metrics of pictures
/// that differ; the image paths stay empty. Pictures of the baseline are read, and have to be those that
/// are listed, where the hashes are equal, too. Quick measures are without SSIM and FLIP, but for the FLIP
/// that a verdict needs.
[[nodiscard]] Judgement judgeFrame(const RunFrame& made, const Reference& reference,
                                   Measures measures = Measures::all);

/// The picture that judgeFrame compared with: number as in FrameResult::alternate. Throws
/// UserError(inputOutput).
[[nodiscard]] frame::Image referencePicture(const Reference& reference, int frame, int alternate);

/// Where a picture that was compared with that one leaves it; `drawn`: its passes. Nothing where it does
/// not, or where the baseline's picture cannot be used.
[[nodiscard]] std::optional<PassPlace> placeOfDifference(const Reference& reference, const RunFrame& made,
                                                         int alternate, const PassDump& drawn);

/// "maxDiffRatio is 0.02, 50 times the 0.0004 observed": bounds over 10 times what any frame came to.
[[nodiscard]] std::vector<std::string> looseBounds(const std::vector<FrameResult>& frames,
                                                   const scene::Tolerance& tolerance);

}  // namespace simreel::golden

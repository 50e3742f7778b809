#pragma once
#include "scene/framing.hpp"
#include "sim/world/color_survey.hpp"

#include <functional>
#include <string>
#include <vector>

namespace simreel::sim {

/// Maximum work of a survey run: bytes of state, counted once per step and weighted by their cost relative
/// to a cloth of springs. Corresponds to about ten seconds of a software driver on two cores; `simreel -v
/// render` prints the work and time of a run.
constexpr double mostSurveyed = 1 << 30;

/// True if the framing of an unplaced camera, or the position of a stage, depends on where cloth and
/// particles move.
[[nodiscard]] bool needsSurvey(const scene::Scene& scene);

/// Result of a survey run: the extents of the objects, and the ranges of their colours.
struct Survey {
  std::vector<scene::Framed> framed;  ///< in the objects' order; only objects with Parameters::framed
  int frames = 0;                     ///< number of frames simulated; 0: the extents follow from the
                                      ///< parameters only
  double work = 0;                    ///< work of all frames, in the unit of mostSurveyed
  std::vector<SeenRange> ranges;      ///< ranges of colours that are "auto", over all frames
};

/// Callback between two frames; may throw to stop the survey.
using SurveyWatch = std::function<void()>;

/// Simulates the whole scene once in exact mode, in a separate World on the current context, and samples
/// cloth and particles in up to 48 evenly spaced frames. The result therefore depends only on the scene,
/// not on the device or the requested frames. Ignores the outermost hundredth of particles in each
/// direction, and points that have left the region given by the parameters by more than its size. If
/// the work would exceed `most` (see mostSurveyed), it samples nothing. Measures the ranges of colours that
/// are "auto" in all frames, whatever the work. Throws the errors of World.
[[nodiscard]] Survey surveyMotion(scene::Scene& scene, const SurveyWatch& watch = {},
                                  double most = mostSurveyed);

/// Moves the scene's stage, and its camera unless that is placed, to fit the surveyed extents; marks the
/// camera as placed. Sets the ranges of colours.
void frameSurvey(scene::Scene& scene, const Survey& survey);
/// True if the survey has measured all ranges of the scene that are "auto".
[[nodiscard]] bool coversRanges(const Survey& survey, scene::Scene& scene);

/// Returns overrides "path=value" that place `camera`: position or orbit distance, target, and field of
/// view or height. Adds near and far if they differ from the values of `before`.
[[nodiscard]] std::vector<std::string> cameraOverrides(const scene::Camera& camera,
                                                       const scene::Camera& before);

struct MotionFraming {
  std::vector<std::string> camera = {};  ///< overrides "path=value" that reproduce the camera; empty if the
                                         ///< scene places its camera
  std::string remark = {};               ///< line for the user; empty: nothing was done
  std::vector<std::string> ranges = {};  ///< overrides that reproduce the ranges of colours
  std::string rangeRemark = {};          ///< line for the user about the ranges; empty: none is "auto"
};

/// Runs the survey and applies it if needsSurvey() or needsRanges() holds; only once per scene.
MotionFraming frameMotion(scene::Scene& scene, const SurveyWatch& watch = {});

}  // namespace simreel::sim

#pragma once
#include "scene/framing.hpp"
#include "sim/world/color_survey.hpp"

#include <functional>
#include <string>
#include <vector>

namespace simreel::sim {

/// Maximum work of a survey run. The work is the number of state bytes summed over all steps, weighted by
/// the cost of a byte relative to a cloth of springs. The maximum takes about ten seconds with a software
/// driver on two cores; `simreel -v render` prints the work and time of a run.
constexpr double maxSurveyWork = 1 << 30;

/// Returns true if the framing of a camera without a position, or the position of a stage, depends on the
/// motion of cloth and particles.
[[nodiscard]] bool needsSurvey(const scene::Scene& scene);

/// Result of a survey run: the extents of the objects and the ends of their colour ranges.
struct Survey {
  std::vector<scene::Framed> framed;  ///< extents of the objects that have Parameters::framed, in the order
                                      ///< of objects
  int frames = 0;                     ///< number of frames simulated; 0 if the extents follow from the
                                      ///< parameters only
  double work = 0;                    ///< work of all frames, in the unit of maxSurveyWork
  std::vector<SeenRange> ranges;      ///< colour ranges measured over all frames
};

/// Callback between two frames; may throw to stop the survey.
using SurveyWatch = std::function<void()>;

/// Simulates the whole scene once in exact mode, in a separate World on the current context, and samples
/// cloth and particles in up to 48 evenly spaced frames. The result therefore depends only on the scene,
/// not on the device or the requested frames. Ignores the outermost 1% of the particles of each frame in
/// each direction, and points that have left the region given by the parameters by more than its size, or
/// by more than twice its size if at most a tenth of the particles have left it by more than once its
/// size. If the work would exceed `maximum` (see maxSurveyWork), it samples no motion. Measures the "auto"
/// colour ranges in all frames, regardless of the work. Throws the errors of World.
[[nodiscard]] Survey surveyMotion(scene::Scene& scene, const SurveyWatch& watch = {},
                                  double maximum = maxSurveyWork);

/// Moves the scene's stage to fit the surveyed extents, and also the camera if the scene does not place it;
/// marks the camera as placed. Sets the colour ranges.
void frameSurvey(scene::Scene& scene, const Survey& survey);
/// Returns true if the survey has measured all "auto" colour ranges of the scene.
[[nodiscard]] bool coversRanges(const Survey& survey, scene::Scene& scene);

/// Returns overrides "path=value" that place `camera`: position or orbit distance, target, and field of
/// view or height. Adds near and far if they differ from the values of `before`.
[[nodiscard]] std::vector<std::string> cameraOverrides(const scene::Camera& camera,
                                                       const scene::Camera& before);

struct MotionFraming {
  std::vector<std::string> camera = {};  ///< overrides "path=value" that reproduce the camera; empty if the
                                         ///< scene places its camera
  std::string remark = {};               ///< line for the user; empty if nothing was changed
  std::vector<std::string> ranges = {};  ///< overrides "path=value" that reproduce the colour ranges
  std::string rangeRemark = {};          ///< line for the user about the colour ranges; empty if none is
                                         ///< "auto"
};

/// Runs the survey and applies its result if needsSurvey() or needsRanges() returns true. Call it only once
/// per scene.
MotionFraming frameMotion(scene::Scene& scene, const SurveyWatch& watch = {});

}  // namespace simreel::sim

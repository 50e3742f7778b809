#pragma once
#include "scene/framing.hpp"

#include <functional>
#include <string>
#include <vector>

namespace simreel::sim {

/// Bytes of state that a run to frame a scene may step through at most, counted in each of its steps and
/// by what they cost beside those of a cloth of springs: up to some ten seconds of a software driver on two
/// cores (`simreel -v render` says how many there were, and how long it took).
constexpr double mostSurveyed = 1 << 30;

/// Whether a camera that the scene places nowhere would have in view, or a stage stand under, what only a
/// run can tell: where cloth and particles go.
[[nodiscard]] bool needsSurvey(const scene::Scene& scene);

/// Where a scene's objects went.
struct Survey {
  std::vector<scene::Framed> framed;  ///< in their order, those that ask for it (Parameters::framed)
  int frames = 0;                     ///< that were simulated for it; 0: as the parameters tell
  double work = 0;                    ///< as mostSurveyed counts, of all frames
};

/// Called between two frames; may throw to end it.
using SurveyWatch = std::function<void()>;

/// Simulates all of the scene once, exactly, in a world of its own on the current context, and looks at
/// cloth and particles in up to 48 frames, evenly from the first to the last: so what comes out depends on
/// the scene alone, not on the device nor on the frames that are wanted. Of particles the one in a hundred
/// that is farthest out in a direction is left out; of what falls away that which has left the room where
/// its parameters have it by more than its size. Nothing is simulated where that would step through more
/// than `most` (mostSurveyed). Throws what World does.
[[nodiscard]] Survey surveyMotion(scene::Scene& scene, const SurveyWatch& watch = {},
                                  double most = mostSurveyed);

/// Moves the scene's stage, and its camera unless that is placed, so that they have it in view; the camera
/// counts as placed.
void frameSurvey(scene::Scene& scene, const Survey& survey);

struct MotionFraming {
  std::vector<std::string> camera = {};  ///< overrides that place a scene's camera there: "path=value";
                                         ///< none where the scene does
  std::string remark = {};               ///< a line for the user; empty: nothing was to be done
};

/// All of that, where needsSurvey() and once for a scene.
MotionFraming frameMotion(scene::Scene& scene, const SurveyWatch& watch = {});

}  // namespace simreel::sim

#include "batch/render/chosen_frames.hpp"

#include "base/log.hpp"
#include "frame/frames_spec.hpp"

#include <numeric>

namespace simreel::batch {

void warnBeyondEnd(int frame, const scene::Scene& scene) {
  const int last = scene.frameCount() - 1;
  if (frame > last)
    warn("frame {} is beyond the scene's last frame, {} ({:g} s); the simulation continues past the end",
         frame, last, scene.time.duration);
}

std::vector<int> chosenFrames(const std::optional<std::string>& text, const scene::Scene& scene) {
  if (text) {
    std::vector<int> frames = frame::parseFrames(*text, "--frames", scene.frameCount() - 1);
    warnBeyondEnd(frames.back(), scene);
    return frames;
  }
  std::vector<int> all(static_cast<std::size_t>(scene.frameCount()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace simreel::batch

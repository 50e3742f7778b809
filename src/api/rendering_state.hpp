#pragma once
#include "api/device_state.hpp"
#include "api/simreel/rendering.hpp"
#include "base/clock.hpp"
#include "batch/render/render_job.hpp"
#include "scene/scene_input.hpp"

#include <memory>
#include <string>

namespace simreel {

namespace api {

/// Returns the input of a scene. `text`: its text; nullopt: it is read from the file.
[[nodiscard]] scene::SceneInput inputOf(std::string file, std::optional<std::string> text,
                                        const LoadOptions& options);

/// Returns the request for a run that corresponds to the options of the public interface. Throws
/// Error(usage) or UserError(usage) for an option that has no meaning.
[[nodiscard]] batch::RenderRequest requestOf(scene::SceneInput input, const std::string& output,
                                             const RenderOptions& options);

}  // namespace api

struct Rendering::State {
  /// Reads the scene and checks the options. Throws Error.
  [[nodiscard]] static std::unique_ptr<State> make(scene::SceneInput input, const std::string& output,
                                                   const RenderOptions& options);
  State(batch::RenderRequest request, Clock::time_point start) : began(start), job(std::move(request)) {}
  /// Renders, as Rendering::run() does.
  RenderResult run(Device::State& device, const RenderEvents& events);

  Clock::time_point began;
  batch::RenderJob job;
  bool hasRun = false;
};

}  // namespace simreel

#pragma once
#include "draw/screen/single_view.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <memory>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Draws frames: the scene with its chosen rasterizer, then fields, axes and charts on top. A scene with
/// panels is drawn once for each panel.
class Renderer {
 public:
  /// Loads all textures of the scene's materials. Shaders are compiled on first use. Throws
  /// UserError(device) if a device limit (samples, size) is exceeded, and UserError(inputOutput) or
  /// UserError(usage) if a texture cannot be loaded. The scene must outlive this object.
  Renderer(const scene::Scene& scene, glm::ivec2 size, int samples, const RendererOptions& options = {});
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  using StageWatch = draw::StageWatch;
  /// Issues the commands that draw the frame at `seconds` of scene time. Does not wait for the GPU.
  void draw(double seconds, const sim::Drawables& drawables, const StageWatch& watch = {});

  /// Sets the objects of the frame that precedes the next draw(). Motion starts at their positions.
  /// Required if needsPreviousFrame() is true; otherwise objects are drawn without motion.
  void setPreviousFrame(const sim::Drawables& before);

  /// True if the renderer needs setPreviousFrame(), which a shutter and the velocities of keepLayers()
  /// require.
  [[nodiscard]] bool needsPreviousFrame() const;

  /// Sets the object that receives the pass outputs of later pictures, replacing earlier contents. Null:
  /// pass outputs are not stored. The CPU waits for the GPU to copy them. Requires the exact rasterizer.
  void keepPasses(PassPicture* passes);

  /// Requests the light and layers of all later pictures. The CPU then waits for the GPU. Requires the
  /// exact rasterizer. Throws UserError(usage) for scenes with panels. If the light is requested as the
  /// film shows it, draw() throws UserError(usage) for pictures with overlays.
  void keepLayers(const LightRequest& wanted);
  /// Returns the light and layers of the last picture.
  [[nodiscard]] PictureLayers takeLayers();

  /// Returns the framebuffer with the finished picture: RGBA8, sRGB-encoded. Row 0 of a read-back is the
  /// top row.
  [[nodiscard]] const gl::Framebuffer& target() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Determines the kernels that a Renderer needs for a frame with these drawables, and lets software drivers
/// compile them on idle processors. Does not change pictures. Does nothing if it would not save time.
/// Should be called before the first frame is simulated.
void compileAhead(const scene::Scene& scene, glm::ivec2 size, int samples, double seconds,
                  const sim::Drawables& drawables, const RendererOptions& options = {});

}  // namespace simreel::draw

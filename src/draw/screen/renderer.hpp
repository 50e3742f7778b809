#pragma once
#include "draw/exact/passes.hpp"
#include "draw/exact/scene/picture_layers.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include <glm/vec2.hpp>

namespace simreel::draw {

struct RendererOptions {
  std::optional<scene::Rasterizer> rasterizer;  ///< instead of the scene's
  /// What the exact rasterizer keeps of visibility at most; larger pictures are drawn in bands of rows,
  /// with the same bytes.
  std::size_t visibilityBytes = std::size_t{256} << 20;
};

/// Draws one frame: the scene with the rasterizer it asks for, then fields, axes and charts over it.
class Renderer {
 public:
  /// Loads every texture the scene's materials name; shaders are compiled at their first use. Throws
  /// UserError: device for limits (samples, size), inputOutput or usage for textures. The scene must
  /// outlive it.
  Renderer(const scene::Scene& scene, glm::ivec2 size, int samples, const RendererOptions& options = {});
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Called when the commands of a stage have been issued; stages that have nothing to do are left out. A
  /// stage may come in parts. Names: those of the entries of draw/exact/pass_list.hpp, and "fields"; of
  /// the driver's rasterizer "shadow", "surfaces", "instances", "ground", "bloom", "tone map", "fields".
  using StageWatch = std::function<void(const char* stage)>;
  /// Issues the commands for the frame at `seconds` (of scene time); does not wait.
  void draw(double seconds, const sim::Drawables& drawables, const StageWatch& watch = {});

  /// What there was to be drawn of the frame before that which draw() is called for next: where
  /// hearsBefore(), things move from there. Without it they stand still.
  void keepBefore(const sim::Drawables& before);

  /// Whether it wants to hear so: for a shutter, or for the velocities of keepLayers().
  [[nodiscard]] bool hearsBefore() const;

  /// From now on the passes of a picture are kept there as it is drawn, in place of those before; null:
  /// nowhere. They are copied to the CPU, which waits for the device. The rasterizer must be the exact one.
  void keepPasses(PassPicture* passes);

  /// From now on the light of a picture is kept as it is drawn, with layers; the CPU waits for it. The
  /// rasterizer must be the exact one. What the film shows is kept of pictures over which nothing lies;
  /// draw() throws UserError(usage) for others.
  void keepLayers(const LightRequest& wanted);
  /// That of the last picture.
  [[nodiscard]] PictureLayers takeLayers();

  /// RGBA8, sRGB-encoded; row 0 of a read-back is the picture's top row.
  [[nodiscard]] const gl::Framebuffer& target() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Finds out which kernels a Renderer will need for a frame with such drawables, and has a software driver
/// compile them on the processors that are idle meanwhile. Changes no picture; does nothing where there is
/// nothing to gain. Best before the first frame is simulated.
void compileAhead(const scene::Scene& scene, glm::ivec2 size, int samples, double seconds,
                  const sim::Drawables& drawables, const RendererOptions& options = {});

}  // namespace simreel::draw

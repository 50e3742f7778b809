#pragma once
#include "draw/environment.hpp"
#include "draw/exact/passes.hpp"
#include "draw/exact/scene/picture_layers.hpp"
#include "draw/overlay/field_pass.hpp"
#include "draw/overlay/field_textures.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include <glm/vec2.hpp>

namespace simreel::draw {

class Motion;

/// Memory that one band of a picture may take.
struct BandRoom {
  std::size_t samples;     ///< of visibility
  std::int64_t glowBytes;  ///< of sums of glows, in one buffer
};
/// As many rows of a picture as there is room for, in whole tiles: one at least.
[[nodiscard]] int rowsOfBands(glm::ivec2 size, int samples, const BandRoom& room);

/// Draws all but what lies over the finished picture by kernels in exact arithmetic: the same bytes on
/// every device.
class ExactScene {
 public:
  /// Visibility that comes to more than `visibilityBytes`, and glows whose sums one buffer does not hold,
  /// are found band by band, 8 rows at least each.
  /// Throws UserError: usage for what it cannot draw, device for limits. The scene must outlive it, and so
  /// the sky's picture, if there is one.
  ExactScene(const scene::Scene& scene, const Environment* environment, glm::ivec2 size, int samples,
             std::size_t visibilityBytes);
  ~ExactScene();
  ExactScene(ExactScene&&) = delete;
  ExactScene& operator=(ExactScene&&) = delete;
  ExactScene(const ExactScene&) = delete;
  ExactScene& operator=(const ExactScene&) = delete;

  /// The fields of the frame: as skins read them, and as they lie behind the scene.
  struct Overlays {
    const FieldTextures& textures;
    FieldPass& fields;
  };
  using Watch = std::function<void(const char* stage)>;
  /// What is to be seen at a time.
  struct Moment {
    double seconds = 0;  ///< of scene time
    const sim::Drawables* drawables = nullptr;
  };
  /// Moments of which a picture is the mean.
  struct Exposure {
    int moments = 1;
    /// Number i, which lives until the next is asked for; the frame's uniform block is that moment's then.
    std::function<Moment(int i)> at;
    std::function<void()> close = {};  ///< after the last: the uniform block is to be the frame's again
    Motion* motion = nullptr;  ///< since the frame before, which has begun; null: nobody asks for it
    double frameSeconds = 1;   ///< between the two frames
    float part = 1;            ///< of the way that the first moment stands at
  };
  /// Into an RGBA8 picture, row 0 at the top. `frame`: what fields, bloom and film are of. The frame's
  /// uniform block is bound.
  void draw(const Exposure& exposure, const Moment& frame, const Overlays& overlays,
            const gl::Texture& picture, const Watch& watch);
  /// From now on a picture's passes are kept there, in place of those before; null: nowhere.
  void keepPasses(PassPicture* passes);
  /// From now on the light of a picture is kept as it is drawn, with layers; the CPU waits for it. Where a
  /// camera has a lens or a shutter layers are those of the first point at the first moment.
  void keepLayers(const LightRequest& wanted);
  /// That of the last picture.
  [[nodiscard]] PictureLayers takeLayers();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::draw

#pragma once
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"
#include "sim/drawable.hpp"

#include <map>
#include <string>

namespace simreel::draw {

/// Fields as textures with mip maps, made once a frame by a kernel that reads the simulation's memory. What
/// is not shown and not the skin of anything is left alone.
class FieldTextures {
 public:
  /// Knows from the scene's materials which fields are skins.
  explicit FieldTextures(const scene::Scene& scene);

  struct Entry {
    gl::Texture
        texture;        ///< R32F values, or RGBA16F linear light of categories; row 0 is the field's row 0
    gl::Texture stops;  ///< RGBA32F texel view of the colours (values only)
    gl::Buffer stopBuffer;
    int stopCount = 0;
    glm::ivec2 cells{0, 0};  ///< of the field; the texture may be smaller by a whole factor
    int reduction = 1;       ///< cells a texel on a side, averaged
    glm::vec2 range{0, 1};
    bool colored = false;  ///< categories: the texture holds colours
  };
  /// Brings the textures of all fields of a frame up to date.
  void update(const sim::Drawables& drawables);
  /// Null when no field of that name was published.
  [[nodiscard]] const Entry* find(const std::string& name) const;

 private:
  std::map<std::string, Entry> entries_;
};

}  // namespace simreel::draw

#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Vertices of a grid that lie evenly over a plane: a component of a surface's positions is their height.
struct GridHeights {
  glm::vec2 corner{0};                  ///< m: x and z of the first one
  float cell = 1;                       ///< m between them
  float base = 0;                       ///< m: where height 0 is
  int component = 1;                    ///< of positions: 1 or 3
  int walls = 0;                        ///< bits of the sides west, east, north, south at which the
  float rim = 0;                        ///< height (m) is at least this
  const gl::Texture* colors = nullptr;  ///< R16F texel view: number in the palette; null: positions' w
};

/// Indexed triangles pulled from buffers by gl_VertexID; nothing is copied. All pointers stay owned by
/// the simulation and live until its next step.
struct Surface {
  const std::string* object = nullptr;  ///< its name in the scene, where the world published it
  const gl::Texture* positions =
      nullptr;  ///< RGBA32F texel view, one texel a vertex: xyz in m, w unused but for a palette
  const gl::Texture* normals = nullptr;  ///< RGBA32F texel view, xyz; null for a grid
  const gl::Texture* uvs = nullptr;      ///< RG32F texel view; null for a grid
  /// Width and height of a grid of vertices (x fastest) whose normals come from neighbours and whose
  /// uv = (x/(W-1), y/(H-1)); zero for a mesh.
  glm::ivec2 grid{0, 0};
  int vertexCount = 0;  ///< vertices that bound the surface: all, but where others lie within their box
  int vertexRoom = 0;   ///< vertices that there may be, where these are more
  /// Set where positions are not such: texels of a grid of which one component is a height.
  const GridHeights* heights = nullptr;
  const gl::Buffer* indices = nullptr;  ///< 32-bit
  /// Those that there are of a grid, where the other rows of cells are like the first one; 0: all.
  int rowIndices = 0;
  int indexCount = 0;
  /// Arguments of an indirect draw that the GPU has written (five words); null: indexCount indices.
  const gl::Buffer* arguments = nullptr;
  /// RGBA32F texel view, linear RGB by the number that positions have in w: instead of the material's
  /// colour.
  const gl::Texture* palette = nullptr;
  /// RGBA32F texel view, one texel a vertex: linear RGB that the material's colour is multiplied with.
  const gl::Texture* colors = nullptr;
  /// Set when the vertex shader displaces: uniform DeformStep of glsl/mesh/types.glsl, and the trail;
  /// positions and normals are those at rest, positions' w the distance between vertices.
  const gl::Buffer* deform = nullptr;
  const gl::Texture* trail = nullptr;  ///< RGBA32F texel view
  glm::mat4 model{1.0F};               ///< rigid, or uniformly scaled
  bool doubleSided = false;
  /// A number that no other mesh has, if positions, normals and indices are never written again; else 0.
  unsigned still = 0;
  /// s: when its object last jumped along its keyframes (Simulation::jumpedBy).
  double jumped = -std::numeric_limits<double>::infinity();
  const scene::Material* material = nullptr;
};

/// Many copies of one small mesh, or camera-facing sprites, one for each living particle. Nothing about
/// them is known to the CPU but their greatest number: a kernel drops the dead and those out of sight and
/// fills the arguments of the indirect draw.
struct Instances {
  enum class Shape { sprite, sphere, mesh };
  enum class ColorBy { material, speed, mass, age };
  const std::string* object = nullptr;     ///< its name in the scene, where the world published it
  const gl::Texture* positions = nullptr;  ///< RGBA32F texel view: xyz in m, w mass in kg
  const gl::Texture* velocities =
      nullptr;  ///< RGBA32F texel view: xyz in m/s, w age 0 to 1, exactly 0: ages not; negative: not alive
  int capacity = 0;             ///< elements of both
  Shape shape = Shape::sprite;  ///< sprites are lit as balls, or glow when additive
  std::filesystem::path mesh;   ///< OBJ, PLY or glTF file of Shape::mesh
  bool alongVelocity = false;   ///< turns the mesh's z axis along the velocity
  float size = 0.1F;            ///< m: diameter; of a mesh, factor on its coordinates
  float massExponent = 0.0F;    ///< size is multiplied with (mass / massReference)^exponent
  float massReference = 1.0F;   ///< kg
  ColorBy colorBy = ColorBy::material;
  glm::vec2 colorRange{0, 1};                      ///< of speed (m/s), mass (kg) or age, mapped to 0..1
  const std::vector<glm::vec3>* colors = nullptr;  ///< linear RGB stops of the colour map, evenly spaced
  bool additive = false;    ///< light that adds up (HDR), no shadow; else opaque, with shadow
  float brightness = 1.0F;  ///< factor on the colours of additive ones
  float fade = 0.0F;        ///< fraction of life over which additive ones fade in and out
  /// Additive sprites are discs that face the eye however small they are: towards the borders of a wide
  /// picture ellipses. Else small ones are round, as a driver's points are. (The driver's rasterizer has
  /// discs where the middle is beyond a border or they are large.)
  bool discs = false;
  glm::vec3 boundsMin{0}, boundsMax{0};  ///< m; a box for the shadow map's fit; empty: measured on the GPU
  const scene::Material* material = nullptr;
};

/// Whether what is drawn is drawn into shadow maps, too.
[[nodiscard]] inline bool castsShadow(const Surface& surface) {
  return surface.material->castsShadow;
}
[[nodiscard]] inline bool castsShadow(const Instances& instances) {
  return !instances.additive && instances.material->castsShadow;
}

/// Empty where nobody gave it one.
[[nodiscard]] inline std::string objectName(const Surface& surface) {
  return surface.object != nullptr ? *surface.object : std::string();
}
[[nodiscard]] inline std::string objectName(const Instances& instances) {
  return instances.object != nullptr ? *instances.object : std::string();
}

/// Where and how a field is laid over the picture (field_display.hpp).
struct FieldDisplay;

/// A 2-D grid of cells, read straight from the simulation's memory. Cell (0, 0) is the top left one of the
/// picture and the one at uv (0, 0) of a skin.
struct Field {
  enum class Cells { bits, bytes, floats, colors };
  const std::string* name = nullptr;   ///< of the object; skins ask for it
  const gl::Texture* words = nullptr;  ///< RGBA32UI texel view of the state, of floats too
  Cells cells = Cells::floats;  ///< lowest bit or byte of a word first; bytes are 0 to 255; colors: linear
                                ///< RGB and the value that skins take, four floats
  glm::ivec2 size{0, 0};        ///< cells
  int rowWords = 0;             ///< 32-bit words from one row to the next
  int firstWord = 0;            ///< of cell (0, 0)
  int cellWords = 1;            ///< of floats: words from a cell to the next
  bool categories = false;      ///< a value is the number of its colour; else a place in `range`
  glm::vec2 range{0, 1};        ///< values of the first and the last colour
  const std::vector<glm::vec3>* colors =
      nullptr;                            ///< linear RGB: stops, evenly spaced, or one per category
  const FieldDisplay* display = nullptr;  ///< null: not laid over the picture
};

/// Curves over the picture: what a simulation counted in each step so far.
struct Chart {
  const gl::Texture* counts = nullptr;  ///< RGBA32UI texel view, one texel a step: up to four counts
  int steps = 0;                        ///< counted so far
  int width = 1;                        ///< steps along the whole x axis, at least `steps`
  unsigned max = 1;                     ///< count at the top of the y axis
  float zero = 0;                       ///< part of that height towards which curves are filled
  std::string range = {};               ///< said of the y axis; empty: "max" and its count
  std::string length = {};              ///< said of the x axis; empty: its steps
  std::vector<std::string> names;       ///< of the first counts, at most four
  std::vector<glm::vec3> colors;        ///< linear RGB, one each
  glm::vec2 corner{0.025F, 0.6F};       ///< top left of its panel, as fractions of the picture
  glm::vec2 extent{0.36F, 0.36F};       ///< width and height of its panel, as fractions of the picture
};

/// Text over the finished picture.
struct Writing {
  const std::string* object = nullptr;  ///< its name in the scene, where the world published it
  /// Closed polygons, y up, in heights of a capital from the anchor; filled is what they go round.
  const std::vector<std::vector<glm::vec2>>* outlines = nullptr;
  glm::vec2 place{0};     ///< of the anchor, as fractions of the picture from its top left
  float height = 0.03F;   ///< of a capital, as a fraction of the picture's height
  glm::vec3 color{1};     ///< linear RGB
  float opacity = 1.0F;   ///< 0 to 1
  float backdrop = 0.0F;  ///< opacity of a dark panel behind it
};

/// A way through a scene, from its beginning to its end: cameras go along it, and what a scene places by it
/// stands on it.
struct Path {
  const std::string* name = nullptr;               ///< of the object
  const std::vector<glm::vec3>* points = nullptr;  ///< m, in the scene's space, on the ground; one at least
};

/// Where the middle of an object is that a camera looks at.
struct Place {
  const std::string* object = nullptr;  ///< its name in the scene
  glm::vec3 middle{0};                  ///< m
  /// s: when it last jumped along keyframes.
  double jumped = -std::numeric_limits<double>::infinity();
};

/// What a simulation publishes for drawing: a list per kind, one pass each.
struct Drawables {
  std::vector<Surface> surfaces = {};
  std::vector<Instances> instances = {};
  std::vector<Field> fields = {};
  std::vector<Chart> charts = {};
  std::vector<Path> paths = {};
  std::vector<Writing> writings = {};
  std::vector<Place> places = {};  ///< of the object that the scene's camera looks at, if there is one
  /// m: what the scene's camera looks at where that lags behind what the scene says
  /// (scene::Camera::damping, scene::Follow::damping), and where it stands if that does, too.
  std::vector<glm::vec3> lagging = {};
};

}  // namespace simreel::sim

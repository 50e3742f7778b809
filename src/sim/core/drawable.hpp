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

/// Regular grid of vertices over a horizontal plane, where one component of the surface's `positions` is
/// the height.
struct GridHeights {
  glm::vec2 corner{0};  ///< Corner of the grid: x and z of the first vertex, in metres.
  float cell = 1;       ///< Distance in metres between neighbouring vertices.
  float base = 0;       ///< World height (metres) of height value 0.
  int component = 1;    ///< Index of the height component in `positions`: 1 or 3.
  int walls = 0;  ///< Bit mask of the sides (west, east, north, south) with a minimum height of `rim`.
  float rim = 0;  ///< Minimum height in metres at the sides in `walls`.
  const gl::Texture* colors =
      nullptr;  ///< R16F texel view of palette indices. If null, w of `positions` is the index.
};

/// Indexed triangles that the vertex shader pulls from buffers by gl_VertexID; nothing is copied. The
/// simulation owns everything pointed to and keeps it valid until its next step.
struct Surface {
  const std::string* object = nullptr;     ///< Name of the object in the scene; null if the surface was not
                                           ///< published by an object of a scene.
  const gl::Texture* positions = nullptr;  ///< RGBA32F texel view with one texel per vertex: xyz is the
                                           ///< position in metres. w is the palette index if there is a
                                           ///< palette; otherwise it is unused.
  const gl::Texture* normals = nullptr;    ///< Vertex normals: RGBA32F texel view, xyz; null for a grid.
  const gl::Texture* uvs = nullptr;        ///< Texture coordinates: RG32F texel view; null for a grid.
  /// Width and height of a vertex grid (x fastest); zero for a mesh. A grid computes its normals from
  /// neighbouring vertices and its UVs as (x/(W-1), y/(H-1)).
  glm::ivec2 grid{0, 0};
  int vertexCount = 0;     ///< Number of leading vertices whose bounding box encloses all vertices.
  int vertexCapacity = 0;  ///< Maximum number of vertices, if larger than `vertexCount`.
  /// Set if `positions` holds grid texels with a height component instead of vertex positions.
  const GridHeights* heights = nullptr;
  const gl::Buffer* indices = nullptr;  ///< Triangle indices of 32 bits each.
  /// Number of indices in one row of cells if a grid stores indices for its first row only; 0 if all rows
  /// are stored.
  int rowIndices = 0;
  int indexCount = 0;
  /// Indirect draw arguments (five words) written by the GPU. If null, `indexCount` indices are drawn.
  const gl::Buffer* arguments = nullptr;
  /// RGBA32F texel view of linear RGB colours, indexed by w of `positions`. Replaces the material's colour.
  const gl::Texture* palette = nullptr;
  /// RGBA32F texel view with one texel per vertex: a linear RGB factor that multiplies the material's
  /// colour.
  const gl::Texture* colors = nullptr;
  /// Evenly spaced linear RGB stops of a colour map that is applied to w of `colors`; null if `colors`
  /// holds RGB factors.
  const std::vector<glm::vec3>* stops = nullptr;
  glm::vec2 colorRange{0, 1};  ///< Values of w that map to the first and to the last stop.
  /// Uniform buffer with a DeformStep (glsl/mesh/types.glsl). If set, the vertex shader displaces the
  /// vertices using `trail`; `positions` and `normals` then describe the undeformed mesh, and w of
  /// `positions` is the distance between vertices.
  const gl::Buffer* deform = nullptr;
  const gl::Texture* trail =
      nullptr;  ///< RGBA32F texel view of the trail pressed into the surface; the displacement reads it.
  glm::mat4 model{1.0F};  ///< Model matrix: rigid, or with uniform scale.
  bool doubleSided = false;
  /// Unique identifier of a mesh whose positions, normals and indices never change; 0 for a mesh that may
  /// change.
  unsigned still = 0;
  /// Time (seconds) of the object's last jump along its keyframes (Simulation::jumpedBy).
  double lastJumpSeconds = -std::numeric_limits<double>::infinity();
  const scene::Material* material = nullptr;
};

/// Instances of a small mesh, or camera-facing sprites, one per live particle. The CPU holds only the
/// maximum count: a kernel culls dead and invisible instances and writes the arguments of the indirect
/// draw.
struct Instances {
  enum class Shape { sprite, sphere, mesh };
  enum class ColorBy { material, speed, mass, age };
  /// Orientation of a mesh instance: unrotated; z axis along the velocity or along a given direction, with
  /// a horizontal x axis; or given by a quaternion.
  enum class Turning { none, velocity, direction, quaternion };
  const std::string* object = nullptr;     ///< Name of the object in the scene; null if the instances were
                                           ///< not published by an object of a scene.
  const gl::Texture* positions = nullptr;  ///< RGBA32F texel view: xyz position in metres, w mass in kg.
  const gl::Texture* velocities =
      nullptr;  ///< RGBA32F texel view: xyz velocity in m/s; w is the age as a fraction of life (0 to 1),
                ///< exactly 0 if the particle does not age, negative if it is dead.
  int capacity = 0;             ///< Number of elements in `positions` and in `velocities`.
  Shape shape = Shape::sprite;  ///< Opaque sprites are shaded as spheres, additive sprites glow.
  std::filesystem::path mesh;   ///< OBJ, PLY or glTF file for Shape::mesh.
  Turning turning = Turning::none;
  const gl::Texture* turns = nullptr;  ///< RGBA32F texel view, one texel per element: direction (xyz), or
                                       ///< quaternion (x, y, z, w); null unless `turning` reads it.
  float size = 0.1F;                   ///< Diameter in metres; for a mesh, a factor on its coordinates.
  float massExponent = 0.0F;           ///< Exponent e: the size is multiplied by (mass / massReference)^e.
  float massReference = 1.0F;          ///< Reference mass in kg.
  ColorBy colorBy = ColorBy::material;
  glm::vec2 colorRange{0, 1};  ///< Range of speed (m/s), mass (kg) or age that the colour map spans.
  const std::vector<glm::vec3>* colors = nullptr;  ///< Evenly spaced linear RGB stops of the colour map.
  bool additive = false;    ///< True: blended additively (HDR), without shadow. False: opaque, with shadow.
  float brightness = 1.0F;  ///< Factor on the colours of additive instances.
  float fade = 0.0F;        ///< Fraction of the life over which additive instances fade in and out.
  /// True if additive sprites of every size are drawn as discs that face the eye; near the borders of a
  /// wide picture they appear as ellipses. If false, small sprites are round in screen space, like point
  /// sprites of the driver. (The driver path always draws discs for sprites that are large or have their
  /// centre outside the picture.)
  bool discs = false;
  glm::vec3 boundsMin{0},
      boundsMax{0};  ///< Bounding box in metres for fitting the shadow map; if empty, the GPU measures it.
  const scene::Material* material = nullptr;
};

/// Returns true if the drawable is also drawn into shadow maps.
[[nodiscard]] inline bool castsShadow(const Surface& surface) {
  return surface.material->castsShadow;
}
[[nodiscard]] inline bool castsShadow(const Instances& instances) {
  return !instances.additive && instances.material->castsShadow;
}

/// Returns the name of the drawable's object, or an empty string if none was set.
[[nodiscard]] inline std::string objectName(const Surface& surface) {
  return surface.object != nullptr ? *surface.object : std::string();
}
[[nodiscard]] inline std::string objectName(const Instances& instances) {
  return instances.object != nullptr ? *instances.object : std::string();
}

/// Settings for drawing a field over the picture (field_display.hpp).
struct FieldDisplay;

/// 2-D grid of cells that the renderer reads directly from the simulation's memory. Cell (0, 0) is at the
/// picture's top left and at uv (0, 0) when the field textures a surface.
struct Field {
  enum class Cells { bits, bytes, floats, colors };
  const std::string* name =
      nullptr;  ///< Name of the object, which surfaces use to look up a field as their texture.
  const gl::Texture* words = nullptr;  ///< RGBA32UI texel view of the state, also for float cells.
  Cells cells = Cells::floats;  ///< Cell format. Cells of `bits` and `bytes` (0 to 255) are packed from the
                                ///< lowest bits of each word. A cell of `colors` has four floats: linear
                                ///< RGB, and the value that textured surfaces use.
  glm::ivec2 size{0, 0};        ///< Size of the grid in cells.
  int rowWords = 0;             ///< Stride between rows, in 32-bit words.
  int firstWord = 0;            ///< Word offset of cell (0, 0).
  int cellWords = 1;            ///< Stride between cells in words, for float cells.
  bool categories = false;  ///< True if cell values are palette indices; false if they are mapped through
                            ///< `range` to the colour map.
  glm::vec2 range{0, 1};    ///< Cell values mapped to the first and the last colour.
  const std::vector<glm::vec3>* colors =
      nullptr;  ///< Linear RGB colours: evenly spaced stops, or one colour per category.
  const FieldDisplay* display =
      nullptr;  ///< Overlay settings. If null, the field is not drawn over the picture.
  /// Values and names of the categories that a colour bar shows; null if it shows none.
  const std::vector<std::pair<int, std::string>>* classes = nullptr;
  bool ownColors = false;   ///< True if the cells have the format `colors` and their colours do not come
                            ///< from the colour map.
  bool decoration = false;  ///< True if the field is only part of the layout; its values are then not
                            ///< written to files.
};

/// Line chart, drawn over the picture, of a simulation's counts for each step so far.
struct Chart {
  const std::string* object = nullptr;  ///< Name of the object in the scene; null if the chart belongs to
                                        ///< an object that is more than a chart.
  const gl::Texture* counts = nullptr;  ///< RGBA32UI texel view, one texel per step with up to four counts.
  int steps = 0;                        ///< Number of steps counted so far.
  int width = 1;                        ///< Number of steps that the full x axis spans, at least `steps`.
  unsigned max = 1;                     ///< Count at the top of the y axis.
  float zero = 0;  ///< Height of the baseline as a fraction of the y axis. The area between each curve and
                   ///< the baseline is filled.
  std::string range = {};          ///< Label of the y axis; if empty, "max" and the maximum count are
                                   ///< shown.
  std::string length = {};         ///< Label of the x axis; if empty, the number of steps is shown.
  std::vector<std::string> names;  ///< Names of the curves, at most four.
  std::vector<glm::vec3> colors;   ///< Linear RGB colour of each curve.
  glm::vec2 corner{0.025F, 0.6F};  ///< Top left corner of the panel, as fractions of the picture.
  glm::vec2 extent{0.36F, 0.36F};  ///< Width and height of the panel, as fractions of the picture.
};

/// Text drawn over the finished picture.
struct Writing {
  const std::string* object = nullptr;  ///< Name of the object in the scene; null if the text was not
                                        ///< published by an object of a scene.
  /// Closed, filled polygons relative to the anchor, in units of the cap height; y points up.
  const std::vector<std::vector<glm::vec2>>* outlines = nullptr;
  glm::vec2 place{0};     ///< Position of the anchor, as fractions of the picture from its top left.
  float height = 0.03F;   ///< Cap height, as a fraction of the picture's height.
  glm::vec3 color{1};     ///< Text colour, linear RGB.
  float opacity = 1.0F;   ///< Opacity of the text, 0 to 1.
  float backdrop = 0.0F;  ///< Opacity of a dark panel behind the text.
};

/// Path through a scene. Cameras can follow it, and scene objects can be placed along it.
struct Path {
  const std::string* name = nullptr;  ///< Name of the object that publishes the path.
  const std::vector<glm::vec3>* points =
      nullptr;  ///< Points on the ground from start to end, in metres in scene space; at least one.
};

/// Centre of an object, published for a camera that aims at the object.
struct Place {
  const std::string* object = nullptr;  ///< Name of the object in the scene.
  glm::vec3 middle{0};                  ///< Position of the centre in metres.
  /// Time (seconds) of the object's last jump along its keyframes.
  double lastJumpSeconds = -std::numeric_limits<double>::infinity();
};

/// Everything that simulations publish for drawing: one list per kind of drawable, each drawn by its own
/// pass.
struct Drawables {
  std::vector<Surface> surfaces = {};
  std::vector<Instances> instances = {};
  std::vector<Field> fields = {};
  std::vector<Chart> charts = {};
  std::vector<Path> paths = {};
  std::vector<Writing> writings = {};
  std::vector<Place> places = {};  ///< Centre of the object at which the scene's camera aims; empty if
                                   ///< there is none.
  /// Damped camera state, positions in metres: first the target, if it lags behind the scene's target
  /// (scene::Camera::damping, scene::Follow::damping), then the eye, if the eye lags too.
  std::vector<glm::vec3> dampedCamera = {};
};

}  // namespace simreel::sim

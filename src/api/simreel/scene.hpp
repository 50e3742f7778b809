#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <simreel/device.hpp>
#include <simreel/error.hpp>
#include <simreel/load.hpp>
#include <simreel/rendering.hpp>
#include <simreel/values.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace simreel {

/// State of a scene between two frames, in CPU memory.
class SIMREEL_API Snapshot {
 public:
  ~Snapshot();
  Snapshot(const Snapshot&);
  Snapshot(Snapshot&&) noexcept;
  Snapshot& operator=(const Snapshot&);
  Snapshot& operator=(Snapshot&&) noexcept;
  [[nodiscard]] int frame() const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  friend class Scene;
  struct State;
  explicit Snapshot(std::shared_ptr<const State> state);
  std::shared_ptr<const State> state_;
};

/// A scene with its simulations on the device. The scene starts at frame 0, after the pre-roll. Several
/// scenes may exist at the same time. All functions throw Error. If a stepping function throws
/// Error(device), for example because a simulation became unstable, every function that needs the state
/// throws the same error until restart() or restore().
class SIMREEL_API Scene {
 public:
  /// Reads a scene file, a mesh, a pattern or a shipped scene by name, as `simreel render` does.
  static Scene load(const Device& device, const std::string& file, const LoadOptions& options = {});
  /// Reads a scene from JSON text. `name` is the file name in messages. The folder of `name` is searched
  /// first for the files of the scene.
  static Scene parse(const Device& device, const std::string& text, const std::string& name = "<scene>",
                     const LoadOptions& options = {});
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  [[nodiscard]] std::string title() const;
  [[nodiscard]] double fps() const;
  [[nodiscard]] int frameCount() const;  ///< Returns the number of frames in the scene's duration. The
                                         ///< scene can be simulated beyond the last one.
  [[nodiscard]] int width() const;       ///< Returns the width of pictures in pixels; height() returns the
                                         ///< height.
  [[nodiscard]] int height() const;
  [[nodiscard]] std::vector<ObjectInfo> objects() const;
  /// Returns the warnings about the scene's text.
  [[nodiscard]] std::vector<std::string> remarks() const;

  /// Returns the current frame.
  [[nodiscard]] Frame frame() const;
  /// Simulates up to a frame. Throws Error(usage) if the frame is before the current one.
  Frame advanceTo(int frame);
  /// Simulates a number of frames from the current one. If several threads call this function, the numbers
  /// add up.
  Frame advanceBy(int frames);
  /// Returns to frame 0 of the scene as it was read.
  void restart();
  /// Returns the hash of all state arrays (32 hexadecimal digits), which `simreel trace` and manifests also
  /// contain.
  [[nodiscard]] std::string stateHash();
  /// True from a call of write() until restart(). In this time, the command line would not reach the same
  /// state.
  [[nodiscard]] bool isChanged() const;

  /// Returns the state arrays of all objects.
  [[nodiscard]] std::vector<ArrayInfo> arrays();
  /// Copies a state array from the device.
  [[nodiscard]] Array read(std::string_view object, std::string_view array);
  /// Copies a state array, or one member of its structures, on the card, for other libraries that use CUDA.
  /// Returns nothing if the state is not on a CUDA device or not stored as one array there; read() then is
  /// the way. Throws Error(usage) for a member that does not exist, and for structures without `member`.
  [[nodiscard]] std::optional<DeviceArray> readOnDevice(std::string_view object, std::string_view array,
                                                        std::string_view member = {});
  /// Replaces a state array. `values`: as many as the array's shape has, the last axis fastest; for an
  /// array of structures, their bytes, ArrayInfo::elementBytes for each. Numbers beside them, such as the w
  /// of positions, stay. Throws Error(usage) for NaN and infinity, unless the array has the same bits there
  /// already.
  void write(std::string_view object, std::string_view array, std::span<const float> values);
  void write(std::string_view object, std::string_view array, std::span<const double> values);
  void write(std::string_view object, std::string_view array, std::span<const std::int32_t> values);
  void write(std::string_view object, std::string_view array, std::span<const std::uint32_t> values);
  void write(std::string_view object, std::string_view array, std::span<const std::byte> structures);
  /// Returns the names of the fields: grids of cells with one value each.
  [[nodiscard]] std::vector<std::string> fields();
  /// Copies a field's values from the device. The array has the shape (rows, columns) and the type float32,
  /// as in files of --fields.
  [[nodiscard]] Array field(std::string_view name);
  /// Returns the quantities that an object measures at the current frame. Returns an empty list if the
  /// object measures none.
  [[nodiscard]] std::vector<Quantity> measure(std::string_view object);
  /// Returns the mesh of an object. Throws Error(usage) if the object has no mesh.
  [[nodiscard]] Mesh mesh(std::string_view object);

  /// Writes the present state to a file, a checkpoint as `simreel render --checkpoint-at` writes them, from
  /// which `simreel serve --from` and `simreel render --from` go on. Throws Error(inputOutput).
  void saveState(const std::string& file);
  [[nodiscard]] Snapshot snapshot();
  /// Continues from a state of this scene, or of a scene with the same simulations.
  void restore(const Snapshot& snapshot);

  /// Draws the current frame. The bytes equal those of `simreel render`. If the scene does not place a
  /// camera and objects move freely, the first call simulates the whole scene once to place the camera.
  [[nodiscard]] Picture picture();
  /// Draws the current frame and returns layers. `names`: layer names as in --layers of `simreel render`,
  /// or "light", which is linear light before lens and film, with the shape (rows, columns, 4). The layer
  /// "object" holds indices into layerObjects(), and 0xffffffff for empty pixels. Requires the exact
  /// rasterizer.
  [[nodiscard]] std::vector<Array> layers(const std::vector<std::string>& names);
  /// Returns the names of the objects, in the order of the indices in the layer "object".
  [[nodiscard]] std::vector<std::string> layerObjects() const;

  /// Runs the scene from its start and evaluates its checks. `frames`: frames to draw, from 0, in any
  /// order. The scene's current frame does not change.
  [[nodiscard]] std::vector<CheckResult> check(const std::vector<int>& frames);
  /// Renders the scene from its start to files, as a Rendering does. The scene's current frame does not
  /// change. Throws Error(usage) for a written state, and Error(interrupted) if the rendering was
  /// interrupted.
  RenderResult render(const std::string& output, const RenderOptions& options = {},
                      const RenderEvents& events = {});

 private:
  struct State;
  explicit Scene(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Reads a scene as Scene::load() does, or as Scene::parse() if there is `text`, and throws the same
/// Error(scene) for mistakes. Needs no device. Returns the warnings about the scene's text.
SIMREEL_API std::vector<std::string> validate(const std::string& file, const LoadOptions& options = {},
                                              const std::optional<std::string>& text = std::nullopt);

/// Encodes a picture as PNG.
[[nodiscard]] SIMREEL_API std::vector<std::byte> encodePng(const Picture& picture);

}  // namespace simreel

#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <simreel/device.hpp>
#include <simreel/error.hpp>
#include <simreel/values.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace simreel {

/// Replaces one value of a scene, as -D does.
struct Change {
  std::string path;   ///< dotted: "objects.flag.cloth.fabric"
  std::string value;  ///< JSON; a word without quotes is a string
};

/// How a scene is read.
struct LoadOptions {
  std::vector<Change> changes = {};
  std::vector<std::string> assets = {};  ///< further folders that files of the scene may lie in
  /// True: layers "velocity" and "vector" are available, which cost time in each frame.
  bool motion = false;
};

/// How render() writes.
struct RenderOptions {
  std::optional<std::string> frames = {};  ///< as --frames takes them: "0-99x2,150"; nullopt: all
  bool overwrite = false;
  bool manifest = true;  ///< false: no manifest.json, run.json and as-run.json beside the pictures
};

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

/// A scene with its simulations on the device. It is at frame 0 at first, after the pre-roll. Several
/// scenes may exist at once. All functions throw Error. After an Error(device) of a stepping function, such
/// as a simulation that blew up, every function that needs the state throws the same error until restart()
/// or restore().
class SIMREEL_API Scene {
 public:
  /// Reads a scene file, a mesh, a pattern or a shipped scene by its name, as `simreel render` does.
  static Scene load(const Device& device, const std::string& file, const LoadOptions& options = {});
  /// Reads a scene from JSON text. `name` stands for the file in messages, and its folder is the first one
  /// that is searched for files.
  static Scene parse(const Device& device, const std::string& text, const std::string& name = "<scene>",
                     const LoadOptions& options = {});
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  [[nodiscard]] std::string title() const;
  [[nodiscard]] double fps() const;
  [[nodiscard]] int frameCount() const;  ///< frames of the scene's duration; a scene can go on after them
  [[nodiscard]] int width() const;       ///< of pictures, in pixels
  [[nodiscard]] int height() const;
  [[nodiscard]] std::vector<ObjectInfo> objects() const;
  /// Returns the warnings about the scene's text.
  [[nodiscard]] std::vector<std::string> remarks() const;

  /// Returns the present frame.
  [[nodiscard]] Frame frame() const;
  /// Simulates up to a frame. Throws Error(usage) for an earlier frame than the present one.
  Frame advanceTo(int frame);
  /// Simulates a number of frames from the present one. Calls of several threads add up.
  Frame advanceBy(int frames);
  /// Goes back to frame 0 of the scene as it was read.
  void restart();
  /// Returns the hash of all state arrays (32 hexadecimal digits), as `simreel trace` and manifests have
  /// it.
  [[nodiscard]] std::string stateHash();
  /// True after write(), until restart(): the command line would not reach this state.
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
  /// Copies a field's values from the device: (rows, columns), float32, as --fields writes them.
  [[nodiscard]] Array field(std::string_view name);
  /// Returns what an object measures at the present frame; empty if it measures nothing.
  [[nodiscard]] std::vector<Quantity> measure(std::string_view object);
  /// Returns the mesh of an object. Throws Error(usage) if it has none.
  [[nodiscard]] Mesh mesh(std::string_view object);

  /// Writes the present state to a file, a checkpoint as `simreel render --checkpoint-at` writes them, from
  /// which `simreel serve --from` and `simreel render --from` go on. Throws Error(inputOutput).
  void saveState(const std::string& file);
  [[nodiscard]] Snapshot snapshot();
  /// Goes on from a state of a scene with the same simulations.
  void restore(const Snapshot& snapshot);

  /// Draws the present frame: the bytes of `simreel render`. If the scene places no camera and objects move
  /// freely, the first call simulates the whole scene once to place it.
  [[nodiscard]] Picture picture();
  /// Draws the present frame and returns layers by name, as --layers of `simreel render` names them, or
  /// "light" (rows, columns, 4): linear light before lens and film. "object" holds indices into
  /// layerObjects(), 0xffffffff where nothing is. Needs the exact rasterizer.
  [[nodiscard]] std::vector<Array> layers(const std::vector<std::string>& names);
  /// Returns the names of the objects that the layer "object" numbers.
  [[nodiscard]] std::vector<std::string> layerObjects() const;

  /// Runs the scene from its start and evaluates its checks. `frames`: drawn frames, from 0, in any
  /// order. Leaves the present frame as it is.
  [[nodiscard]] std::vector<CheckResult> check(const std::vector<int>& frames);
  /// Renders the scene from its start to a folder, pictures or a video: the files of `simreel render`.
  /// Returns the names of the files in words. Leaves the present frame as it is.
  std::string render(const std::string& output, const RenderOptions& options = {});

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

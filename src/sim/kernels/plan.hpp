#pragma once
#include "kernels/kernels.hpp"
#include "sim/core/expression.hpp"
#include "sim/kernels/description.hpp"
#include "sim/kernels/slots.hpp"
#include "sim/kernels/table.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simreel::sim {

/// Buffer that the kernels of a file use: a header of fixed members, followed by an array of elements.
struct PlannedBuffer {
  std::string name;
  std::string counterOf;   ///< if this is a counter, name of the buffer that it belongs to
  std::string previousOf;  ///< if this is a copy from before a dispatch, name of the copied buffer
  std::size_t header = 0, stride = 4;
  int guards = 0;            ///< number of additional elements after `count` elements that absorb
                             ///< out-of-bounds accesses
  glm::ivec3 size{1, 1, 1};  ///< number of elements along each axis
  bool sized = false;        ///< true if the scene or a file defines the size
  std::vector<KernelSlot> fixed, element;
  bool written = false, allFloats = true;
  const KernelMemory* given = nullptr;

  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
           static_cast<std::size_t>(size.z);
  }
  /// Number of bytes that kernels can access.
  [[nodiscard]] std::size_t bytes() const {
    return header + (count() + static_cast<std::size_t>(guards)) * stride;
  }
};

/// Texture or image that the kernels of a file use.
struct PlannedTexture {
  std::string name, type, format;  ///< type is "2D", "3D", "2DArray" or "Cube"; format is a GLSL format
                                   ///< name
  std::string values{};            ///< "float", "int" or "uint", the type of the texels in the shader
  glm::ivec3 size{1, 1, 1};
  bool sized = false, written = false;
  bool formatted = false;  ///< true if the shader or the scene defines the format
  const KernelMemory* given = nullptr;

  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
           static_cast<std::size_t>(size.z);
  }
  /// Returns the sampler state (bits as in simreel_Samplers) for reading this texture with the sampler of
  /// the given name.
  [[nodiscard]] unsigned samplerState(std::string_view sampler) const;
  [[nodiscard]] bool integers() const { return format.ends_with("i"); }
  [[nodiscard]] bool singleChannel() const {
    return format.starts_with("r") && !format.starts_with("rg") && !format.starts_with("r11");
  }
};

/// Component of a constant or of a thread count.
struct PlannedNumber {
  double number = 0;
  std::shared_ptr<const Expression> expression;  ///< null if `number` is the value
};

/// Entry of a schedule.
struct PlannedEntry {
  int kernel = -1;  ///< index of the kernel in the shader; -1 if the entry is no dispatch
  std::vector<PlannedNumber> threads;
  int repeat = 1, every = 1;
  int indirect = -1;  ///< index of a buffer, or -1 for none
  std::size_t offset = 0;
  std::string swapA, swapB, clear;
  int count = -1, into = -1;  ///< indices of buffers, or -1 for none
};

/// Drawings of a scene, with defaults filled in.
struct PlannedDrawing {
  std::optional<KernelSurface> surface;
  std::optional<KernelPoints> points;
  std::optional<KernelField> field;
  std::optional<KernelTerrain> terrain;
  std::optional<KernelVolume> volume;
  std::optional<KernelWind> wind;

  /// Returns true if something is drawn in the world, not only over the picture.
  [[nodiscard]] bool inSpace() const { return surface || points || terrain || volume; }
};

/// A scene's description of its kernels, checked against the contents of their file. Needs no device.
class KernelPlan {
 public:
  /// Error in a scene: JSON path of the value, and byte range in its text.
  struct Mistake {
    std::vector<std::string> path;
    std::size_t begin = 0, end = 1;
    std::string message;
  };

  /// Compiles the file. The result is cached until the file or one of its includes changes.
  [[nodiscard]] static std::shared_ptr<const kernels::Shader> shaderOf(const kernels::Request& request);

  /// `announced` holds the names of all kernels in the file; `shader` contains only those that run.
  /// `aliases` lists textures of the shader that use the memory of another texture.
  KernelPlan(const KernelDescription& parameters, std::shared_ptr<const kernels::Shader> shader,
             const std::vector<std::string>& announced,
             const std::map<std::string, std::string>& aliases = {});

  [[nodiscard]] const std::vector<Mistake>& mistakes() const { return mistakes_; }
  [[nodiscard]] const kernels::Shader& shader() const { return *shader_; }
  [[nodiscard]] const std::shared_ptr<const kernels::Shader>& shaderPointer() const { return shader_; }
  [[nodiscard]] const std::vector<PlannedBuffer>& buffers() const { return buffers_; }
  [[nodiscard]] const std::vector<PlannedTexture>& textures() const { return textures_; }
  [[nodiscard]] const std::vector<PlannedEntry>& first() const { return first_; }
  [[nodiscard]] const std::vector<PlannedEntry>& step() const { return step_; }
  [[nodiscard]] const PlannedDrawing& drawn() const { return drawn_; }
  /// Sets the colour ranges of the drawing to the ranges in `description`.
  void setColorRanges(const KernelDescription& description);
  [[nodiscard]] int bufferNamed(std::string_view name) const;
  [[nodiscard]] int textureNamed(std::string_view name) const;
  /// Returns the size of the buffer or texture with the given name.
  [[nodiscard]] glm::ivec3 sizeOf(const std::string& memory) const;
  /// Returns the values that can be set in one element of the buffer named `memory` (its members), or in
  /// one texel of the texture with that name (its channels); empty if neither exists.
  [[nodiscard]] std::vector<KernelSlot> slots(const std::string& memory) const;
  /// Returns a bounding box of the initial drawing, or nothing if the drawing has no position in space.
  [[nodiscard]] std::optional<scene::Box> box() const;

  /// Return the initial contents: PlannedBuffer::bytes() bytes for a buffer, four numbers per texel for a
  /// texture.
  [[nodiscard]] std::vector<std::byte> firstBytes(const PlannedBuffer& buffer, unsigned seed) const;
  [[nodiscard]] std::vector<double> firstTexels(const PlannedTexture& texture, unsigned seed) const;

  /// Values of the variables in the expressions of constants and thread counts.
  struct Now {
    double dt = 0, time = 0;
    long frame = 0, step = 0;
    int seed = 1;
    std::span<const double> quantities = {};  ///< values of quantities(); missing values count as zero
  };
  [[nodiscard]] std::vector<double> values(const Now& now) const;
  /// Quantity of another object that constants use: its name OBJECT.QUANTITY, and the JSON path of the
  /// constant.
  struct Quantity {
    std::string name;
    std::vector<std::string> path;
  };
  [[nodiscard]] const std::vector<Quantity>& quantities() const { return quantities_; }
  /// Returns the contents of a uniform block.
  [[nodiscard]] std::vector<std::byte> blockBytes(const kernels::Block& block, const Now& now) const;
  [[nodiscard]] glm::uvec3 groups(const PlannedEntry& entry, const Now& now) const;

 private:
  /// Value of a constant: numbers for all its elements, or formulas for one element.
  struct Constant {
    std::vector<PlannedNumber> parts;
    std::optional<scene::Animated<glm::vec4>> moving;
    std::size_t width = 0;
    const KernelTable* table = nullptr;  ///< file with a row per element, or null
    /// Columns of the table that the formulas use: index in the list of variables, and column.
    std::vector<std::pair<std::size_t, std::size_t>> columns = {};
    bool counts = false;    ///< true if a formula uses i, the element's index
    int countPlace = -1;    ///< index of i in the list of variables
    bool changes = false;   ///< true if the value may differ between dispatches
    bool fromFile = false;  ///< true if the formulas are the columns of the table
  };
  /// Constant that a slot takes its value from, and the index of the slot's struct in its array.
  struct Found {
    const Constant* constant = nullptr;
    std::size_t element = 0;
  };
  void collectBuffer(const kernels::Buffer& from);
  void collectTexture(const kernels::Texture& from);
  void holdNames(const KernelDescription& parameters);
  void size(const KernelDescription& parameters);
  void holdFormat(PlannedTexture& texture, const std::string& format);
  void sizeOf(const char* list, const KernelMemory& given, int axes, glm::ivec3& size, bool& sized);
  void holdBytes();
  void planConstants(const KernelDescription& parameters);
  void planConstantFiles(const KernelDescription& parameters);
  void holdConstants();
  void holdBlock(const kernels::Kernel& kernel, const kernels::Block& block, std::set<std::string>& used);
  void holdConstant(Constant& constant, const std::string& name, const KernelSlot& slot,
                    std::size_t elements);
  [[nodiscard]] Found constantOf(const std::string& path) const;
  /// Returns the index of i or a table column in the list of variables, or -1. Only formulas of constants
  /// have these names.
  int placeInConstant(const std::string& name);
  int placeOfLookup(const std::string& name, double value);
  [[nodiscard]] double numberOf(const Found& found, const KernelSlot& slot, std::size_t i, const Now& now,
                                std::vector<double>& all) const;
  void planEntries(const std::vector<KernelEntry>& given, const char* list,
                   const std::vector<std::string>& announced, int perFrame,
                   std::vector<PlannedEntry>& planned);
  /// Returns the file of the shader that declares a kernel; empty if none does.
  [[nodiscard]] std::string announcedIn(const std::string& kernel) const;
  void planThreads(const KernelEntry& given, const std::vector<std::string>& path, PlannedEntry& entry);
  void planBetween(const KernelEntry& given, const std::vector<std::string>& path, PlannedEntry& entry);
  void everyKernel();
  void useUsualThreads(std::vector<std::string> path, PlannedEntry& entry);
  /// Returns true if a file of the shader contains the word, even if no scheduled kernel uses it.
  [[nodiscard]] bool mentioned(const std::string& word) const;
  void planStarts();
  void planStart(const PlannedBuffer& buffer);
  void planStart(const PlannedTexture& texture);
  void checkStartArray(const char* list, const KernelMemory& given, const scene::Formulas::Named& named,
                       const KernelSlot& slot, glm::ivec3 size);
  void planDrawing(const KernelDescription& parameters);
  [[nodiscard]] std::vector<std::string> bufferNames() const;
  bool checkBufferSize(const char* group, const std::string& of);
  void planSurface(KernelSurface& surface);
  void planPoints(const KernelPoints& points);
  void planField(const KernelField& field);
  void chooseDrawing(FieldDisplay::Fit fit);
  void planGrids();
  [[nodiscard]] scene::Box boxOfTerrain() const;
  [[nodiscard]] scene::Box boxOfVolume() const;
  /// Reports an error if the grid `of` does not have `axes` axes, or if a member of it has too few numbers.
  bool checkGridSize(const char* group, const char* key, const std::string& of, const std::string& member,
                     std::size_t numbers, int axes);
  bool holdMember(const char* group, const char* key, const std::string& of, const std::string& member,
                  bool needed, std::size_t minimum);
  void planMeasures(const KernelDescription& parameters);
  PlannedNumber compiled(const scene::Formula::Part& part, std::vector<std::string> path);
  int placeOf(const std::string& name);
  /// Returns the memory named in an expression such as "count(NAME)"; empty if the shader has no memory of
  /// that name.
  [[nodiscard]] std::string unsizedIn(const std::string& name) const;
  void mistake(std::vector<std::string> path, std::string message, std::size_t begin = 0,
               std::size_t end = 1);
  void unknown(std::vector<std::string> path, const std::string& name,
               const std::vector<std::string>& known, const std::string& what);

  std::shared_ptr<const kernels::Shader> shader_;
  std::map<std::string, std::string, std::less<>> aliases_;
  std::vector<PlannedBuffer> buffers_;
  std::vector<PlannedTexture> textures_;
  std::vector<PlannedEntry> first_, step_;
  std::map<std::string, Constant> constants_;
  std::vector<std::pair<std::string, double>>
      lookups_;  ///< values of count(NAME) and similar functions; in the list of variables, they follow the
                 ///< plain variables
  std::vector<Quantity> quantities_;
  std::vector<std::size_t> quantityPlaces_;  ///< index of each quantity in lookups_
  Constant* planned_ = nullptr;              ///< constant that is being planned, or null
  std::string plannedName_;                  ///< its name
  PlannedDrawing drawn_;
  std::vector<Mistake> mistakes_;
  KernelTables tables_;
  std::vector<KernelMemory> givenBuffers_, givenTextures_;
};

}  // namespace simreel::sim

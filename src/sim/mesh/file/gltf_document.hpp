#pragma once
#include "base/strict_json.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace simreel::sim {

/// "my%20buffer.bin" names "my buffer.bin".
[[nodiscard]] std::string decodePercent(const std::string& uri);

/// The JSON of a glTF file and the bytes that it describes. Throws UserError, as loadMesh() does, and
/// JsonError, for what is not so.
class GltfDocument {
 public:
  GltfDocument(const std::filesystem::path& file, std::string_view text);

  [[nodiscard]] JsonValue root() const { return JsonValue(json_); }
  /// The nodes that are drawn, without those below them: of the default scene; of a file without scenes,
  /// the roots of all its nodes.
  [[nodiscard]] std::vector<std::uint64_t> rootNodes() const;
  /// An object of a list of the document, such as the accessor 3.
  [[nodiscard]] JsonValue item(const char* list, std::size_t number) const;
  [[nodiscard]] std::size_t size(const char* list) const;
  /// A whole number of an object, `otherwise` where it has none; required without that.
  [[nodiscard]] static std::uint64_t number(const JsonValue& object, const char* key,
                                            std::optional<std::uint64_t> otherwise = {});
  /// Numbers of an object's list, which has to hold `count`; empty where there is no list.
  [[nodiscard]] static std::vector<float> numbers(const JsonValue& object, const char* key,
                                                  std::size_t count);
  /// Whole numbers of an object's list; empty if it has no such list.
  [[nodiscard]] static std::vector<std::uint64_t> wholeNumbers(const JsonValue& object, const char* key);
  /// The rotation of a node as a quaternion x, y, z, w, normalized.
  [[nodiscard]] static std::array<double, 4> rotation(const JsonValue& node);

  /// How many vertices or indices an accessor has; checked against its bytes.
  [[nodiscard]] std::size_t count(std::size_t accessor) const;
  /// How many components each of them has.
  [[nodiscard]] std::size_t components(std::size_t accessor) const;
  /// The values of an accessor with that many components each, normalised where it says so.
  [[nodiscard]] std::vector<float> floats(std::size_t accessor, std::size_t components) const;
  /// The values of an accessor of whole numbers.
  [[nodiscard]] std::vector<std::uint32_t> indices(std::size_t accessor) const;

  /// The bytes that an object's "uri" names, in the text or beside the file,
  [[nodiscard]] std::string bytesAt(const std::string& uri) const { return bytesOf(uri, 0); }
  /// Why a file beside it is not to be read (whyUnread()),
  [[nodiscard]] std::string whyUnreadAt(const std::string& uri) const;
  /// and those of a buffer view.
  [[nodiscard]] std::string bytesOfView(std::size_t number) const;

  /// Number of bytes of a binary file after the end that its header gives.
  [[nodiscard]] std::size_t bytesBehind() const { return behind_; }

  [[noreturn]] void refuse(const std::string& why) const;

 private:
  /// Values that lie in a buffer view.
  struct Values {
    std::string_view bytes;
    std::size_t count, stride, components;
    std::uint64_t type;  ///< component type
    bool normalised;
  };

  void checkVersion() const;
  std::string_view openGlb(std::string_view text);
  std::string_view buffer(std::size_t number) const;
  std::string bytesOf(const std::string& uri, std::uint64_t promised) const;
  [[nodiscard]] std::string_view view(std::size_t number, std::size_t& stride) const;
  [[nodiscard]] Values values(const JsonValue& accessor) const;
  [[nodiscard]] Values slice(const JsonValue& place, std::uint64_t type, std::size_t components,
                             std::size_t count) const;
  [[nodiscard]] float component(const Values& values, std::size_t element, std::size_t component) const;

  const std::filesystem::path& file_;
  nlohmann::json json_;
  std::optional<std::string_view> glbBytes_;
  std::size_t behind_ = 0;
  mutable std::vector<std::optional<std::string>> buffers_;  ///< what was loaded so far
};

}  // namespace simreel::sim

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

/// Decodes percent escapes: "my%20buffer.bin" becomes "my buffer.bin".
[[nodiscard]] std::string decodePercent(const std::string& uri);

/// JSON of a glTF file, with access to the binary data that the JSON describes. Throws UserError, as
/// loadMesh() does, and JsonError for invalid content.
class GltfDocument {
 public:
  GltfDocument(const std::filesystem::path& file, std::string_view text);

  [[nodiscard]] JsonValue root() const { return JsonValue(json_); }
  /// Returns the root nodes of the default scene, without their children; if the file has no scenes, the
  /// nodes that are no node's child.
  [[nodiscard]] std::vector<std::uint64_t> rootNodes() const;
  /// Returns element `number` of one of the document's lists, such as "accessors".
  [[nodiscard]] JsonValue item(const char* list, std::size_t number) const;
  [[nodiscard]] std::size_t size(const char* list) const;
  /// Returns an unsigned integer member of an object. If it is missing, returns `otherwise`, or throws if
  /// `otherwise` is empty.
  [[nodiscard]] static std::uint64_t number(const JsonValue& object, const char* key,
                                            std::optional<std::uint64_t> otherwise = {});
  /// Returns a list of exactly `count` numbers; empty if the member is missing.
  [[nodiscard]] static std::vector<float> numbers(const JsonValue& object, const char* key,
                                                  std::size_t count);
  /// Returns a list of numbers of any length; empty if the member is missing.
  [[nodiscard]] static std::vector<float> numbers(const JsonValue& object, const char* key);
  /// Returns a list of unsigned integers; empty if the member is missing.
  [[nodiscard]] static std::vector<std::uint64_t> wholeNumbers(const JsonValue& object, const char* key);
  /// Returns a node's rotation as a normalized quaternion x, y, z, w.
  [[nodiscard]] static std::array<double, 4> rotation(const JsonValue& node);

  /// Returns the number of elements of an accessor, checked against the available bytes.
  [[nodiscard]] std::size_t count(std::size_t accessor) const;
  /// Returns the number of components per element of an accessor.
  [[nodiscard]] std::size_t components(std::size_t accessor) const;
  /// Returns the values of an accessor, normalized if the accessor says so. The accessor must have
  /// `components` components per element.
  [[nodiscard]] std::vector<float> floats(std::size_t accessor, std::size_t components) const;
  /// Returns the values of an integer accessor.
  [[nodiscard]] std::vector<std::uint32_t> indices(std::size_t accessor) const;

  /// Returns the bytes that a "uri" refers to: embedded in the text, or in a file in the document's folder.
  [[nodiscard]] std::string bytesAt(const std::string& uri) const { return bytesOf(uri, 0); }
  /// Returns the reason why the file that a "uri" refers to is not read (see whyUnread()).
  [[nodiscard]] std::string whyUnreadAt(const std::string& uri) const;
  /// Returns the bytes of a buffer view.
  [[nodiscard]] std::string bytesOfView(std::size_t number) const;

  /// Returns the number of bytes in a binary file after the end given in its header.
  [[nodiscard]] std::size_t bytesBehind() const { return behind_; }

  [[noreturn]] void refuse(const std::string& why) const;

 private:
  /// View of an accessor's values in a buffer view.
  struct Values {
    std::string_view bytes;
    std::size_t count, stride, components;
    std::uint64_t type;  ///< glTF component type
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
  mutable std::vector<std::optional<std::string>> buffers_;  ///< buffers loaded so far
};

}  // namespace simreel::sim

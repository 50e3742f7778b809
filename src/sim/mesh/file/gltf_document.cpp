#include "sim/mesh/file/gltf_document.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"
#include "base/text.hpp"
#include "sim/mesh/file/builder.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace simreel::sim {

namespace {

static_assert(std::endian::native == std::endian::little, "values are copied as they lie in the file");

constexpr std::int64_t maxNumber = std::int64_t{1} << 40;  // maximum for numbers in the file, so that the
                                                           // product of two does not overflow
constexpr std::size_t maxContainers = 500'000;             // limited because each container takes at least
                                                           // 100 bytes of memory
constexpr std::size_t maxZeros = 1'000'000;

template <class T>
T read(std::string_view bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// Returns the size in bytes of a glTF component type; 0 for an unknown type.
std::size_t componentBytes(std::uint64_t type) {
  constexpr std::uint64_t first = 5120;
  constexpr std::array<std::size_t, 7> bytes = {1, 1, 2, 2, 0, 4, 4};
  return type >= first && type - first < bytes.size() ? bytes[type - first] : 0;
}

std::string decodeBase64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int have = 0;
  for (const char c : text) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) break;
    bits = bits << 6U | static_cast<std::uint32_t>(digit);
    if ((have += 6) < 8) continue;
    have -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(have) & 255U);
  }
  return bytes;
}

/// Returns the number of components of an accessor's type; 0 for an unsupported type.
std::size_t componentsOf(const JsonValue& accessor) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 5> types = {
      {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}}};
  const std::string type = accessor.at("type").text();
  std::size_t components = 0;
  for (const auto& [name, count] : types)
    if (type == name) components = count;
  return components;
}

}  // namespace

std::string decodePercent(const std::string& uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const auto hex = [&](std::size_t at) {
      return at < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[at])) != 0;
    };
    if (uri[i] == '%' && hex(i + 1) && hex(i + 2)) {
      name += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      name += uri[i];
    }
  }
  return name;
}

GltfDocument::GltfDocument(const std::filesystem::path& file, std::string_view text) : file_(file) {
  if (text.substr(0, 4) == "glTF") text = openGlb(text);
  json_ = parseStrictJson(text, {.containers = maxContainers});
  checkVersion();
  buffers_.resize(size("buffers"));
}

void GltfDocument::checkVersion() const {
  const JsonValue asset = root().at("asset");
  // In version 1, "version" may be a number instead of a string.
  const JsonValue written = asset.at("version");
  if (written.json().is_number() || !written.text().starts_with("2.")) refuse("is no glTF of version 2");
  if (!asset.has("minVersion")) return;
  if (const std::string minimum = asset.at("minVersion").text(); minimum != "2.0")
    refuse(fmt::format("requires glTF {}, but only glTF 2.0 is supported", oneLine(minimum.substr(0, 20))));
}

/// Returns the JSON of a binary file, which is its first chunk, and stores the binary data of the second
/// chunk.
std::string_view GltfDocument::openGlb(std::string_view text) {
  std::array<std::string_view, 2> chunks;
  std::size_t at = 12;
  if (text.size() < at) refuse("is cut off, or is not a binary glTF of version 2");
  if (const auto version = read<std::uint32_t>(text, 4); version != 2)
    refuse(fmt::format("is a binary glTF of version {}, and only 2 is read", version));
  const std::size_t whole = read<std::uint32_t>(text, 8);
  if (whole > text.size())
    refuse(fmt::format("is cut off: its header announces {} bytes, but it has {}", whole, text.size()));
  behind_ = text.size() - whole;
  text = text.substr(0, whole);
  for (std::string_view& chunk : chunks) {
    if (at == text.size() && at > 12) break;
    const std::size_t length = text.size() < at + 8 ? text.size() : read<std::uint32_t>(text, at);
    if (length > text.size() - std::min(at + 8, text.size()))
      refuse("is cut off, or is not a binary glTF of version 2");
    chunk = text.substr(at + 8, length);
    if (&chunk != chunks.data()) glbBytes_ = chunk;
    at += 8 + length;
  }
  return chunks[0];
}

void GltfDocument::refuse(const std::string& why) const {
  refuseMesh(file_, why);
}

std::size_t GltfDocument::size(const char* list) const {
  const auto found = root().find(list);
  return found ? found->size() : 0;
}

std::vector<std::uint64_t> GltfDocument::rootNodes() const {
  if (size("scenes") > 0) return wholeNumbers(item("scenes", number(root(), "scene", 0)), "nodes");
  std::vector<bool> below(size("nodes"));
  for (std::size_t i = 0; i < below.size(); ++i)
    for (const std::uint64_t child : wholeNumbers(item("nodes", i), "children"))
      if (child < below.size()) below[child] = true;
  std::vector<std::uint64_t> roots;
  for (std::size_t i = 0; i < below.size(); ++i)
    if (!below[i]) roots.push_back(i);
  return roots;
}

JsonValue GltfDocument::item(const char* list, std::size_t number) const {
  if (number >= size(list)) refuse(fmt::format("names number {} of its {} {}", number, size(list), list));
  return root().at(list).at(number);
}

std::uint64_t GltfDocument::number(const JsonValue& object, const char* key,
                                   std::optional<std::uint64_t> otherwise) {
  if (otherwise && !object.has(key)) return *otherwise;
  return static_cast<std::uint64_t>(object.at(key).integer<std::int64_t>(0, maxNumber));
}

std::vector<float> GltfDocument::numbers(const JsonValue& object, const char* key) {
  std::vector<float> all;
  if (const auto found = object.find(key))
    found->eachItem([&](const JsonValue& item) { all.push_back(static_cast<float>(item.number())); });
  return all;
}

std::vector<float> GltfDocument::numbers(const JsonValue& object, const char* key, std::size_t count) {
  std::vector<float> all = numbers(object, key);
  if (const auto found = object.find(key); found && all.size() != count)
    found->wrong(fmt::format("must be a list of {} numbers", count));
  return all;
}

std::vector<std::uint64_t> GltfDocument::wholeNumbers(const JsonValue& object, const char* key) {
  std::vector<std::uint64_t> all;
  if (const auto found = object.find(key))
    found->eachItem([&](const JsonValue& item) {
      all.push_back(static_cast<std::uint64_t>(item.integer<std::int64_t>(0)));
    });
  return all;
}

std::array<double, 4> GltfDocument::rotation(const JsonValue& node) {
  const std::vector<float> q = numbers(node, "rotation", 4);
  if (q.empty()) return {0, 0, 0, 1};
  std::array<double, 4> unit = {q[0], q[1], q[2], q[3]};
  double squared = 0;
  for (const double part : unit) squared += part * part;
  if (!(squared > 1e-12 && std::isfinite(squared)))
    node.at("rotation").wrong("must be a quaternion of length 1");
  constexpr double rounding = 1e-5;
  if (std::abs(squared - 1) > rounding)
    for (double& part : unit) part /= std::sqrt(squared);
  return unit;
}

std::string GltfDocument::bytesOf(const std::string& uri, std::uint64_t promised) const {
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(";base64,");
    if (comma == std::string::npos) refuse("has a buffer in its text that is not in base64");
    return decodeBase64(std::string_view(uri).substr(comma + 8));
  }
  const std::filesystem::path path = file_.parent_path() / decodePercent(uri);
  const bool ofLooks = promised == 0;  // true for textures, which may be in any folder that the scene may
                                       // read
  if (!liesBeside(file_, path) && !(ofLooks && whyUnread(file_, path).empty()))
    refuse(fmt::format("names {}, which lies outside its folder", path.string()));
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    refuse(fmt::format("names {}, which does not exist or is not a regular file", path.string()));
  const auto size = std::filesystem::file_size(path, error);
  if (error || size < promised)
    refuse(fmt::format("has a buffer of {} bytes, of which {} holds {}", promised, path.string(), size));
  return readFile(path, "buffer");
}

std::string_view GltfDocument::buffer(std::size_t number) const {
  const JsonValue described = item("buffers", number);
  const std::uint64_t promised = this->number(described, "byteLength");
  std::string_view bytes;
  const auto uri = described.find("uri");
  if (!uri) {
    const auto extensions = described.find("extensions");
    if (extensions && extensions->has("EXT_meshopt_compression"))
      refuse("has its vertices only in EXT_meshopt_compression, which is not read; export it without");
    if (number != 0 || !glbBytes_) refuse(fmt::format("has no bytes for its buffer {}", number));
    bytes = *glbBytes_;
  } else {
    std::optional<std::string>& loaded = buffers_.at(number);
    if (!loaded) loaded = bytesOf(uri->text(), promised);
    bytes = *loaded;
  }
  if (bytes.size() < promised)
    refuse(fmt::format("has a buffer of {} bytes, of which {} are there", promised, bytes.size()));
  return bytes.substr(0, promised);
}

std::string_view GltfDocument::view(std::size_t number, std::size_t& stride) const {
  const JsonValue described = item("bufferViews", number);
  const std::string_view bytes = buffer(this->number(described, "buffer"));
  const std::uint64_t offset = this->number(described, "byteOffset", 0);
  const std::uint64_t length = this->number(described, "byteLength");
  if (offset > bytes.size() || length > bytes.size() - offset)
    refuse(fmt::format("has a view of bytes {} to {} in a buffer of {}", offset, offset + length,
                       bytes.size()));
  stride = this->number(described, "byteStride", stride);
  return bytes.substr(offset, length);
}

std::string GltfDocument::whyUnreadAt(const std::string& uri) const {
  return whyUnread(file_, file_.parent_path() / decodePercent(uri));
}

std::string GltfDocument::bytesOfView(std::size_t number) const {
  std::size_t stride = 0;
  return std::string(view(number, stride));
}

GltfDocument::Values GltfDocument::slice(const JsonValue& place, std::uint64_t type, std::size_t components,
                                         std::size_t count) const {
  const std::size_t element = components * componentBytes(type);
  if (element == 0) refuse(fmt::format("has values of type {}, which is not a glTF type", type));
  std::size_t stride = element;
  const std::string_view bytes = view(number(place, "bufferView"), stride);
  const std::uint64_t offset = number(place, "byteOffset", 0);
  if (stride < element || stride > 1024)
    refuse(fmt::format("has values of {} bytes with a stride of {}", element, stride));
  const std::uint64_t end = offset + (count - 1) * stride + element;
  if (end > bytes.size())
    refuse(fmt::format("has an accessor whose count is {}: {} bytes, of which its view holds {}", count,
                       end, bytes.size()));
  return {bytes.substr(offset), count, stride, components, type, false};
}

std::size_t GltfDocument::count(std::size_t accessor) const {
  const JsonValue described = item("accessors", accessor);
  const auto count =
      static_cast<std::size_t>(described.at("count").integer<std::int64_t>(1, 3 * maxMeshItems));
  if (described.has("bufferView"))
    static_cast<void>(values(described));
  else if (count > maxZeros)
    refuse(fmt::format("has an accessor whose count is {} and whose bytes are missing", count));
  return count;
}

std::size_t GltfDocument::components(std::size_t accessor) const {
  return componentsOf(item("accessors", accessor));
}

GltfDocument::Values GltfDocument::values(const JsonValue& accessor) const {
  const std::size_t components = componentsOf(accessor);
  if (components == 0) refuse("has an accessor that is no number, vector or matrix of 4x4");
  Values values = slice(accessor, number(accessor, "componentType"), components, number(accessor, "count"));
  const auto normalised = accessor.find("normalized");
  values.normalised = normalised && normalised->boolean();
  return values;
}

float GltfDocument::component(const Values& values, std::size_t element, std::size_t component) const {
  const std::size_t at = element * values.stride + component * componentBytes(values.type);
  // The most negative integer also maps to -1 (glTF 2.0, 3.11).
  const auto scaled = [&](auto number) {
    const auto value = static_cast<float>(number);
    return values.normalised
               ? std::max(value / static_cast<float>(std::numeric_limits<decltype(number)>::max()), -1.0F)
               : value;
  };
  switch (values.type) {
    case 5120:
      return scaled(read<std::int8_t>(values.bytes, at));
    case 5121:
      return scaled(read<std::uint8_t>(values.bytes, at));
    case 5122:
      return scaled(read<std::int16_t>(values.bytes, at));
    case 5123:
      return scaled(read<std::uint16_t>(values.bytes, at));
    case 5126:
      return read<float>(values.bytes, at);
    default:
      refuse("has 32-bit whole numbers where vertices are expected");
  }
}

std::vector<float> GltfDocument::floats(std::size_t accessor, std::size_t components) const {
  const JsonValue described = item("accessors", accessor);
  const std::size_t count = this->count(accessor);
  std::vector<float> all(count * components, 0.0F);
  const auto put = [&](const Values& values, std::size_t from, std::size_t to) {
    for (std::size_t k = 0; k < components; ++k) all[to * components + k] = component(values, from, k);
  };
  if (described.has("bufferView")) {
    const Values values = this->values(described);
    if (values.components != components)
      refuse(fmt::format("has vectors of {} where {} numbers are expected", values.components, components));
    for (std::size_t i = 0; i < count; ++i) put(values, i, i);
  }
  const auto sparse = described.find("sparse");
  if (!sparse) return all;
  const std::size_t changed = number(*sparse, "count");
  if (changed < 1 || changed > count)
    refuse(fmt::format("has a sparse accessor that replaces {} of {} values", changed, count));
  const JsonValue places = sparse->at("indices");
  const Values where = slice(places, number(places, "componentType"), 1, changed);
  const Values what = slice(sparse->at("values"), number(described, "componentType"), components, changed);
  for (std::size_t i = 0; i < changed; ++i) {
    const std::uint64_t to = where.type == 5125
                                 ? read<std::uint32_t>(where.bytes, i * where.stride)
                                 : static_cast<std::uint64_t>(std::max(component(where, i, 0), 0.0F));
    if (to >= count)
      refuse(fmt::format("has a sparse accessor with the index {}, but only {} values", to, count));
    put(what, i, to);
  }
  return all;
}

std::vector<std::uint32_t> GltfDocument::indices(std::size_t accessor) const {
  const JsonValue described = item("accessors", accessor);
  const std::size_t count = this->count(accessor);
  if (!described.has("bufferView") || described.has("sparse"))
    refuse("has sparse indices, which are not read");
  const Values values = this->values(described);
  std::vector<std::uint32_t> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = i * values.stride;
    if (values.components == 1 && values.type == 5121)
      all[i] = read<std::uint8_t>(values.bytes, at);
    else if (values.components == 1 && values.type == 5123)
      all[i] = read<std::uint16_t>(values.bytes, at);
    else if (values.components == 1 && values.type == 5125)
      all[i] = read<std::uint32_t>(values.bytes, at);
    else
      refuse("has indices that are no whole numbers");
  }
  return all;
}

}  // namespace simreel::sim

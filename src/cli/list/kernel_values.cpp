#include "cli/list/kernel_values.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

namespace simreel::cli {

namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

constexpr int textureSide = 256, volumeSide = 64, rowSide = 32, boxSide = 16;

/// Returns the lower-case words of a name: "_NumParticlesX" has "num", "particles" and "x".
Words wordsOf(std::string_view name) {
  Words words;
  bool joins = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    if (std::isalpha(c) == 0) {
      joins = false;
      continue;
    }
    const bool before = i > 0 && std::islower(static_cast<unsigned char>(name[i - 1])) != 0;
    if (!joins || (std::isupper(c) != 0 && before)) words.emplace_back();
    words.back() += static_cast<char>(std::tolower(c));
    joins = true;
  }
  return words;
}

bool isOneOf(const std::string& word, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}
bool hasOneOf(const Words& words, std::initializer_list<std::string_view> list) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& w) { return isOneOf(w, list); });
}

/// Returns the axis (0 to 2) whose number of cells a scalar with this name holds, or -1 if the name means
/// no axis.
int axisOf(const Words& words) {
  if (words.empty() || hasOneOf(words, {"line", "wall", "wave", "brush", "band", "stroke", "border"}))
    return -1;
  const std::string& last = words.back();
  if (isOneOf(last, {"w", "width", "cols", "columns"})) return 0;
  if (isOneOf(last, {"h", "height", "rows"})) return 1;
  if (isOneOf(last, {"depth", "slices"})) return 2;
  return -1;
}

/// True if a name means the number of cells of a grid: "_Resolution", "gridSize", "texSize".
bool isExtent(const Words& words) {
  if (hasOneOf(words, {"resolution", "res", "dim", "dims", "dimension", "dimensions", "rez"})) return true;
  if (!hasOneOf(words, {"size", "extent", "extents"})) return false;
  return words.size() == 1 || hasOneOf(words, {"grid", "map", "tex", "texture", "image", "screen", "field",
                                               "volume", "canvas", "world", "board", "buffer", "sim"});
}

bool isCount(const Words& words) {
  return hasOneOf(words, {"count", "counts", "num", "number", "length", "amount", "total", "max"}) ||
         (words.size() == 1 && words[0] == "n");
}

bool isTexel(const Words& words) {
  return hasOneOf(words, {"texel", "pixel", "inv", "inverse", "rcp"}) &&
         hasOneOf(words, {"size", "res", "resolution"});
}

/// Returns the names of a kernel's buffers and textures. Those that the kernel writes come first.
template <class Memory, class Pick>
Words namesOf(const std::vector<Memory>& all, const Pick& pick) {
  Words names;
  for (const bool writes : {true, false})
    for (const Memory& one : all)
      if (one.writes == writes && pick(one)) names.push_back(one.name);
  return names;
}

bool isIdentity(const sim::KernelSlot& constant) {
  return constant.offsets.size() == 16 && constant.type.find('[') == std::string::npos;
}

}  // namespace

bool isOpen(const kernels::Buffer& buffer) {
  return !buffer.members.empty() && !buffer.members.back().array.empty() &&
         buffer.members.back().array[0] == 0;
}

KernelGuess::KernelGuess(const kernels::Shader& shader) : shader_(shader) {
  bool grid = false, deep = false;
  for (const kernels::Kernel& kernel : shader.kernels) {
    if (!kernel.textures.empty()) return;
    deep = deep || kernel.threads[2] > 1;
    for (const kernels::Block& block : kernel.blocks)
      for (const sim::KernelSlot& slot : sim::slotsOf(block.members)) {
        const Words words = wordsOf(slot.path.substr(slot.path.rfind('.') + 1));
        const bool scalar = slot.offsets.size() == 1;
        grid = grid ||
               (slot.used && (scalar ? axisOf(words) >= 0 : slot.offsets.size() < 4) &&
                (axisOf(words) >= 0 || isExtent(words))) ||
               (slot.used && scalar && isExtent(words) && slot.number != sim::KernelSlot::Number::real);
        deep = deep || (slot.used && scalar && axisOf(words) == 2);
      }
  }
  if (grid) bufferSize_ = deep ? glm::ivec3(boxSide) : glm::ivec3(rowSide, rowSide, 1);
}

glm::ivec3 KernelGuess::textureSize(const kernels::Texture& texture) {
  const bool flat = texture.type == "2D" || texture.type == "Cube";
  return flat ? glm::ivec3(textureSide, textureSide, 1) : glm::ivec3(volumeSide);
}

std::string KernelGuess::gridOf(const kernels::Kernel& kernel) const {
  const Words textures =
      namesOf(kernel.textures, [](const kernels::Texture& t) { return t.type != "Cube"; });
  if (!textures.empty()) return textures.front();
  if (bufferSize_.y == 1) return {};
  const Words buffers = namesOf(kernel.buffers, [](const kernels::Buffer& b) {
    return isOpen(b) && b.counterOf.empty() && b.previousOf.empty();
  });
  return buffers.empty() ? "" : buffers.front();
}

Json KernelGuess::sizeValue(const kernels::Kernel& kernel, const sim::KernelSlot& constant) const {
  const std::string grid = gridOf(kernel);
  if (grid.empty()) return {};
  const Words words = wordsOf(constant.path.substr(constant.path.rfind('.') + 1));
  const std::array<std::string, 3> sizes = {fmt::format("width({})", grid), fmt::format("height({})", grid),
                                            fmt::format("depth({})", grid)};
  const std::size_t count = constant.offsets.size();
  const bool whole = constant.number != sim::KernelSlot::Number::real;
  if (isTexel(words) && !whole) {
    const std::string x = "1 / " + sizes[0], y = "1 / " + sizes[1];
    return count == 1   ? Json(x)
           : count == 2 ? Json{x, y}
           : count == 4 ? Json{x, y, sizes[0], sizes[1]}
                        : Json();
  }
  if (count == 1) {
    if (const int axis = axisOf(words); axis >= 0) return sizes[static_cast<std::size_t>(axis)];
    return isExtent(words) ? Json(sizes[0]) : Json();
  }
  if (count > 4 || !(isExtent(words) || (whole && isCount(words)))) return {};
  if (count == 2) return {sizes[0], sizes[1]};
  if (count == 3) return {sizes[0], sizes[1], sizes[2]};
  return {sizes[0], sizes[1], "1 / " + sizes[0], "1 / " + sizes[1]};
}

std::string KernelGuess::countValue(const kernels::Kernel& kernel, const std::string& name) const {
  const Words names = namesOf(kernel.buffers, [](const kernels::Buffer& b) {
    return isOpen(b) && b.counterOf.empty() && b.previousOf.empty();
  });
  if (names.empty()) return {};
  // _NumParticles is the length of _Particles, regardless of other memory that the kernel writes.
  for (const std::string& buffer : names)
    for (const std::string& of : wordsOf(buffer))
      for (const std::string& word : wordsOf(name))
        if (of.size() > 2 && (of == word || of == word + "s" || of + "s" == word))
          return fmt::format("count({})", buffer);
  return fmt::format("count({})", names.front());
}

Json KernelGuess::value(const kernels::Kernel& kernel, const sim::KernelSlot& constant) const {
  const std::string own = constant.path.substr(constant.path.rfind('.') + 1);
  const Words words = wordsOf(own);
  const std::size_t count = constant.offsets.size();
  const bool whole = constant.number != sim::KernelSlot::Number::real;
  if (hasOneOf(words, {"delta", "dt"}) && count == 1) return "dt";
  std::string name = own;
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  if (name.find("deltat") != std::string::npos) return "dt";
  if (name.find("time") != std::string::npos) return "time";
  if (hasOneOf(words, {"frame", "frames"})) return "frame";
  if (name.find("seed") != std::string::npos) return "seed";
  if (Json size = sizeValue(kernel, constant); !size.is_null()) return size;
  if (count == 1 && whole && isCount(words))
    if (const std::string length = countValue(kernel, own); !length.empty()) return length;
  if (name.find("gravity") != std::string::npos && count == 3) return {0, -9.81, 0};
  if (isIdentity(constant)) return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  if (count == 1) return 1;
  return count <= 4 ? Json(std::vector<int>(count, 0)) : Json(0);
}

}  // namespace simreel::cli

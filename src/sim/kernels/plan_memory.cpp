// The part of KernelPlan that plans memory: names, formats and sizes.
#include "base/error.hpp"
#include "scene/json/words.hpp"
#include "sim/kernels/formats.hpp"
#include "sim/kernels/plan.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr double maxElements = 1 << 28;
/// Maximum number of bytes of memory per object, and number of bytes counted per texel: four channels of 32
/// bits, and a copy of them.
constexpr double maxMemory = 8.0 * (1 << 30), texelMemory = 32;

}  // namespace

void KernelPlan::holdNames(const KernelDescription& /*parameters*/) {
  std::vector<std::string> known;
  for (const PlannedBuffer& buffer : buffers_)
    if (buffer.counterOf.empty() && buffer.previousOf.empty()) known.push_back(buffer.name);
  for (const KernelMemory& given : givenBuffers_) {
    const int place = bufferNamed(given.name);
    if (place < 0 && mentioned(given.name)) continue;
    if (place < 0)
      unknown({"buffers", given.name}, given.name, known, "buffer");
    else
      buffers_[static_cast<std::size_t>(place)].given = &given;
  }
  known.clear();
  for (const PlannedTexture& texture : textures_) known.push_back(texture.name);
  for (const KernelMemory& given : givenTextures_) {
    const int place = textureNamed(given.name);
    if (place < 0 && mentioned(given.name)) continue;
    if (place < 0) {
      unknown({"textures", given.name}, given.name, known, "texture");
      continue;
    }
    PlannedTexture& texture = textures_[static_cast<std::size_t>(place)];
    texture.given = &given;
    if (!given.field.empty() && texture.type != "2D")
      mistake({"textures", given.name, "field"},
              fmt::format("{} is a texture of the kind {}; only those of the kind 2D take a field",
                          texture.name, texture.type));
    holdFormat(texture, given.format);
  }
}

void KernelPlan::holdFormat(PlannedTexture& texture, const std::string& format) {
  if (format.empty()) return;
  const std::vector<std::string> path = {"textures", texture.given->name, "format"};
  if (texelFormat(format) == 0)
    return mistake(path, fmt::format("unknown format {}; {}", scene::inQuotes(format),
                                     scene::suggestion(format, texelFormatNames())));
  if (texelNumbers(format) != texture.values)
    return mistake(path, fmt::format("a texel of {} holds {} numbers, those of {} are {}", texture.name,
                                     texture.values, scene::inQuotes(format), texelNumbers(format)));
  texture.format = format;
  texture.formatted = true;
}

/// Reads a size. `axes` is the number of axes that it must have; 0 stands for one to three.
void KernelPlan::sizeOf(const char* list, const KernelMemory& given, int axes, glm::ivec3& size,
                        bool& sized) {
  if (!given.file.empty()) {
    try {
      const KernelTable& table = tables_.of(given.file);
      if (given.size.empty()) {
        size = {table.size, 1};
        sized = true;
      }
    } catch (const UserError& error) {
      mistake({list, given.name, "file"}, error.what());
    }
  }
  if (given.size.empty()) return;
  if (given.size.moving || given.size.components() > 3)
    return mistake({list, given.name, "size"}, "a size is one to three numbers or expressions");
  if (axes != 0 && given.size.components() != static_cast<std::size_t>(axes))
    return mistake({list, given.name, "size"},
                   fmt::format("this texture has {} axes: expected {} numbers, found {}", axes, axes,
                               given.size.components()));
  glm::ivec3 read(1);
  for (std::size_t i = 0; i < given.size.parts.size(); ++i) {
    const std::size_t before = mistakes_.size();
    const PlannedNumber part = compiled(given.size.parts[i], {list, given.name, "size"});
    if (mistakes_.size() != before) return;
    const double value = part.expression ? part.expression->at(values({})) : part.number;
    if (!(value >= 1 && value <= maxElements) || value != std::floor(value))
      return mistake({list, given.name, "size"},
                     fmt::format("a size is a whole number from 1 to {}, found {}", maxElements, value));
    read[static_cast<int>(i)] = static_cast<int>(value);
  }
  if (1.0 * read.x * read.y * read.z > maxElements)
    return mistake({list, given.name, "size"}, fmt::format("{} x {} x {} are more than {} elements", read.x,
                                                           read.y, read.z, maxElements));
  size = read;
  sized = true;
}

void KernelPlan::size(const KernelDescription& /*parameters*/) {
  const auto each = [&](const auto& deed) {
    for (PlannedTexture& texture : textures_)
      deed("textures", texture, texture.type == "3D" || texture.type == "2DArray" ? 3 : 2);
    for (PlannedBuffer& buffer : buffers_) deed("buffers", buffer, 0);
  };
  // The size of a memory may depend on another memory. If that is not yet known, the size is computed in a
  // later round.
  for (bool going = true; going;) {
    going = false;
    each([&](const char* list, auto& memory, int axes) {
      if (memory.given == nullptr || memory.sized) return;
      const std::size_t before = mistakes_.size();
      sizeOf(list, *memory.given, axes, memory.size, memory.sized);
      if (memory.sized) going = true;
      mistakes_.resize(before);
    });
  }
  each([&](const char* list, auto& memory, int axes) {
    if (memory.given != nullptr && !memory.sized)
      sizeOf(list, *memory.given, axes, memory.size, memory.sized);
  });
  for (PlannedTexture& texture : textures_) {
    if (texture.type != "Cube" || !texture.sized) continue;
    if (texture.size.x != texture.size.y)
      mistake(
          {"textures", texture.name, "size"},
          fmt::format("the faces of a cube are squares, found {} x {}", texture.size.x, texture.size.y));
    texture.size.z = 6;
  }
  for (PlannedBuffer& buffer : buffers_)
    if (!buffer.previousOf.empty())
      buffer.size = buffers_[static_cast<std::size_t>(bufferNamed(buffer.previousOf))].size;
  for (const PlannedTexture& texture : textures_)
    if (!texture.sized)
      mistake(
          {"textures"},
          fmt::format(
              "the texture {0} has no size; give \"textures\": {{\"{0}\": {{\"size\": [width, height]}}}}",
              texture.name));
  for (const PlannedBuffer& buffer : buffers_)
    if (!buffer.sized)
      mistake({"buffers"},
              fmt::format("the buffer {0} has no size; give \"buffers\": {{\"{0}\": {{\"size\": COUNT}}}}",
                          buffer.name));
  if (mistakes_.empty()) holdBytes();
}

void KernelPlan::holdBytes() {
  double all = 0, largest = 0;
  std::vector<std::string> path;
  const auto add = [&](const char* list, const std::string& name, double bytes) {
    all += bytes;
    if (bytes <= largest) return;
    largest = bytes;
    path = {list, name, "size"};
  };
  for (const PlannedBuffer& buffer : buffers_)
    add("buffers", buffer.name, static_cast<double>(buffer.bytes()));
  for (const PlannedTexture& texture : textures_)
    add("textures", texture.name, texelMemory * static_cast<double>(texture.count()));
  if (all > maxMemory)
    mistake(path, fmt::format(
                      "the buffers and textures need {:.1f} GB (32 bytes per texel), but at most {:.0f} GB "
                      "are allowed; make this one, the largest, smaller",
                      all / (1 << 30), maxMemory / (1 << 30)));
}

}  // namespace simreel::sim

#include "cli/list/kernel_scene.hpp"

#include "cli/list/kernel_values.hpp"
#include "sim/kernels/slots.hpp"
#include "sim/kernels/threads.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string lowered(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

/// Buffers and textures of all kernels. Each name occurs once.
struct Memory {
  std::vector<const kernels::Buffer*> buffers;
  std::vector<const kernels::Texture*> textures;
};

Memory memoryOf(const kernels::Shader& shader) {
  Memory memory;
  std::set<std::string> seen;
  for (const kernels::Kernel& kernel : shader.kernels) {
    for (const kernels::Buffer& buffer : kernel.buffers)
      if (buffer.counterOf.empty() && buffer.previousOf.empty() && seen.insert(buffer.name).second)
        memory.buffers.push_back(&buffer);
    for (const kernels::Texture& texture : kernel.textures)
      if (seen.insert(texture.name).second) memory.textures.push_back(&texture);
  }
  return memory;
}

std::size_t componentsOf(const std::string& type) {
  const char last = type.back();
  const bool matrix =
      type.find("mat") != std::string::npos || (type.size() > 3 && type[type.size() - 2] == 'x');
  if (last < '2' || last > '4') return 1;
  const auto count = static_cast<std::size_t>(last - '0');
  return matrix ? count * count : count;
}

/// True for Unity's time constants, which the program sets.
bool isStandard(const sim::KernelSlot& constant) {
  const bool time = constant.path == "_Time" || constant.path == "_SinTime" ||
                    constant.path == "_CosTime" || constant.path == "unity_DeltaTime";
  return time && constant.offsets.size() == 4;
}

/// Returns the names of buffers that have a counter.
std::set<std::string> countedOf(const kernels::Shader& shader) {
  std::set<std::string> counted;
  for (const kernels::Kernel& kernel : shader.kernels)
    for (const kernels::Buffer& buffer : kernel.buffers) counted.insert(buffer.counterOf);
  return counted;
}

/// Returns a size as a scene gives it, without axes of one element.
Json sizeOf(glm::ivec3 size) {
  if (size.z > 1) return {size.x, size.y, size.z};
  return size.y > 1 ? Json{size.x, size.y} : Json(size.x);
}

Json buffersOf(const Memory& memory, const KernelGuess& guess, const std::set<std::string>& counted) {
  Json buffers = Json::object();
  for (const kernels::Buffer* buffer : memory.buffers) {
    if (!isOpen(*buffer)) continue;
    Json start = Json::object();
    for (const kernels::Member& member : buffer->members.back().members)
      if (lowered(member.name).find("pos") != std::string::npos && componentsOf(member.type) == 3)
        start[member.name] = {"random(1)", "random(2)", "random(3)"};
    if (start.empty() || counted.contains(buffer->name))
      buffers[buffer->name] = sizeOf(guess.bufferSize());
    else
      buffers[buffer->name] = {{"size", sizeOf(guess.bufferSize())}, {"start", start}};
  }
  return buffers;
}

/// Returns the entry of a kernel in the schedule. Adds a guess of the kernel's thread count if the sizes of
/// its memory do not determine it.
Json entryOf(const kernels::Kernel& kernel, const KernelGuess& guess,
             const std::set<std::string>& counted) {
  const sim::KernelSizes sizes = {
      .texture = &KernelGuess::textureSize,
      .buffer =
          [&](const kernels::Buffer& buffer) {
            return isOpen(buffer) ? guess.bufferSize() : glm::ivec3(1);
          },
      .counted = [&](const kernels::Buffer& buffer) { return counted.contains(buffer.name); }};
  if (sim::usualThreads(kernel, sizes)) return kernel.name;
  const auto used = [](const auto& list) {
    const auto found = std::find_if(list.begin(), list.end(), [](const auto& one) { return one.writes; });
    return found == list.end() ? list.begin() : found;
  };
  Json threads = Json::array();
  if (const auto buffer = used(kernel.buffers); sim::isRow(kernel) && buffer != kernel.buffers.end())
    threads.push_back(fmt::format("count({})", buffer->name));
  else if (const auto texture = used(kernel.textures); texture != kernel.textures.end())
    for (const char* axis : {"width", "height"})
      threads.push_back(fmt::format("{}({})", axis, texture->name));
  else
    for (const unsigned size : kernel.threads) threads.push_back(size);
  return {{"kernel", kernel.name}, {"threads", threads}};
}

}  // namespace

std::string sceneOf(const kernels::Shader& shader, const std::filesystem::path& file) {
  const Memory memory = memoryOf(shader);
  const KernelGuess guess(shader);
  Json object = {{"file", file.filename().string()}};
  if (const Json buffers = buffersOf(memory, guess, countedOf(shader)); !buffers.empty())
    object["buffers"] = buffers;
  Json textures = Json::object();
  for (const kernels::Texture* texture : memory.textures)
    textures[texture->name] = sizeOf(KernelGuess::textureSize(*texture));
  if (!textures.empty()) object["textures"] = textures;
  Json constants = Json::object();
  Json step = Json::array();
  const std::set<std::string> counted = countedOf(shader);
  for (const std::string& name : counted)
    if (!name.empty()) step.push_back({{"clear", name + ".counter"}});
  for (const kernels::Kernel& kernel : shader.kernels) {
    step.push_back(entryOf(kernel, guess, counted));
    for (const kernels::Block& block : kernel.blocks) {
      if (block.name == "simreel_Samplers") continue;
      for (const sim::KernelSlot& constant : sim::slotsOf(block.members))
        if (constant.used && !isStandard(constant) && !constants.contains(constant.path))
          constants[constant.path] = guess.value(kernel, constant);
    }
  }
  if (!constants.empty()) object["constants"] = constants;
  object["step"] = step;
  const Json scene = {{"version", 2}, {"objects", {{"mine", {{"kernels", object}}}}}};
  return scene.dump(2) + "\n";
}

}  // namespace simreel::cli

#include "cli/list/kernel_scene.hpp"

#include "cli/list/kernel_values.hpp"
#include "sim/kernels/slots.hpp"
#include "sim/kernels/threads.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>
#include <string_view>
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

/// True for a kernel that, by its name, prepares the first state.
bool preparesStart(const std::string& name) {
  constexpr std::array<std::string_view, 6> words = {"init", "setup", "reset", "seed", "clear", "generate"};
  const std::string low = lowered(name);
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return low.starts_with(word); });
}

/// Returns a name without the words that tell the two halves of a double buffer apart.
std::string withoutHalf(const std::string& name) {
  constexpr std::array<std::string_view, 15> words = {"previous", "current", "output", "input", "write",
                                                      "next",     "prev",    "last",   "read",  "back",
                                                      "front",    "new",     "old",    "out",   "in"};
  const std::string low = lowered(name);
  for (const std::string_view word : words)
    if (const std::size_t at = low.find(word); at != std::string::npos)
      return low.substr(0, at) + low.substr(at + word.size());
  return low;
}

/// Names of what a kernel reads, and of what it writes and the shader reads under the other name: the two
/// halves of a double buffer. Empty if the kernel has none.
struct Halves {
  std::string read, written;
};

/// Finds the halves of a kernel's double buffer among its buffers or textures.
template <class List, class Alike>
std::optional<Halves> halvesAmong(const List& list, const Alike& alike) {
  for (const auto& from : list)
    for (const auto& to : list)
      if (!from.writes && to.writes && &from != &to && alike(from, to) &&
          lowered(from.name) != withoutHalf(from.name) && lowered(to.name) != withoutHalf(to.name) &&
          withoutHalf(from.name) == withoutHalf(to.name))
        return Halves{from.name, to.name};
  return std::nullopt;
}

std::optional<Halves> halvesOf(const kernels::Kernel& kernel) {
  const auto ofTextures =
      halvesAmong(kernel.textures, [](const kernels::Texture& a, const kernels::Texture& b) {
        return a.type == b.type && a.values == b.values;
      });
  if (ofTextures) return ofTextures;
  return halvesAmong(kernel.buffers, [](const kernels::Buffer& a, const kernels::Buffer& b) {
    return isOpen(a) && isOpen(b) && a.counterOf.empty() && b.counterOf.empty() && a.previousOf.empty() &&
           b.previousOf.empty();
  });
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
  // The first half of a double texture starts with random cells, unless a kernel prepares it.
  std::set<std::string> started;
  const auto prepares = [](const kernels::Kernel& kernel) { return preparesStart(kernel.name); };
  if (std::none_of(shader.kernels.begin(), shader.kernels.end(), prepares))
    for (const kernels::Kernel& kernel : shader.kernels)
      if (const std::optional<Halves> halves = halvesOf(kernel)) started.insert(halves->read);
  for (const kernels::Texture* texture : memory.textures) {
    const Json size = sizeOf(KernelGuess::textureSize(*texture));
    if (started.contains(texture->name))
      textures[texture->name] = {{"size", size}, {"start", {{"r", "step(0.7, random(1))"}}}};
    else
      textures[texture->name] = size;
  }
  if (!textures.empty()) object["textures"] = textures;
  Json constants = Json::object();
  Json step = Json::array(), first = Json::array();
  const bool onlyPrepares = std::all_of(shader.kernels.begin(), shader.kernels.end(), prepares);
  const std::set<std::string> counted = countedOf(shader);
  for (const std::string& name : counted)
    if (!name.empty()) step.push_back({{"clear", name + ".counter"}});
  for (const kernels::Kernel& kernel : shader.kernels) {
    Json entry = entryOf(kernel, guess, counted);
    if (prepares(kernel) && !onlyPrepares) {
      first.push_back(entry);
    } else {
      if (const std::optional<Halves> halves = halvesOf(kernel)) {
        if (entry.is_string()) entry = Json{{"kernel", entry}};
        entry["swap"] = {halves->read, halves->written};
      }
      step.push_back(entry);
    }
    for (const kernels::Block& block : kernel.blocks) {
      if (block.name == "simreel_Samplers") continue;
      for (const sim::KernelSlot& constant : sim::slotsOf(block.members))
        if (constant.used && !isStandard(constant) && !constants.contains(constant.path))
          constants[constant.path] = guess.value(kernel, constant);
    }
  }
  if (!constants.empty()) object["constants"] = constants;
  if (!first.empty()) object["first"] = first;
  object["step"] = step;
  const Json scene = {{"version", 2}, {"objects", {{"mine", {{"kernels", object}}}}}};
  return scene.dump(2) + "\n";
}

}  // namespace simreel::cli

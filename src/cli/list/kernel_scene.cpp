#include "cli/list/kernel_scene.hpp"

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

/// Buffers and textures of all kernels, without duplicate names.
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

/// True for Unity's time constants, which the program sets itself.
bool isStandard(const kernels::Member& member) {
  const bool time = member.name == "_Time" || member.name == "_SinTime" || member.name == "_CosTime" ||
                    member.name == "unity_DeltaTime";
  return time && componentsOf(member.type) == 4;
}

/// Returns a default value guessed from the name: time, a size, a seed and so on, else 1.
Json valueOf(const kernels::Member& member, const Memory& memory) {
  const std::string name = lowered(member.name);
  const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
  const std::size_t count = componentsOf(member.type);
  const bool whole = member.type.find("int") != std::string::npos;
  Json value = 1;
  if (has("delta") || name == "dt" || name == "_dt")
    value = "dt";
  else if (has("time"))
    value = "time";
  else if (has("frame"))
    value = "frame";
  else if (has("seed"))
    value = "seed";
  else if (!memory.textures.empty() && (has("width") || has("resolution") || has("size")) && whole)
    value = fmt::format("width({})", memory.textures[0]->name);
  else if (!memory.textures.empty() && has("height"))
    value = fmt::format("height({})", memory.textures[0]->name);
  else if (!memory.buffers.empty() && whole && (has("count") || has("num") || has("length")))
    value = fmt::format("count({})", memory.buffers[0]->name);
  else if (has("gravity") && count == 3)
    return {0, -9.81, 0};
  if (count == 16) return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  if (value != 1 || count == 1) return value;  // one expression sets all components
  return std::vector<int>(count, 0);
}

/// Returns the names of buffers that have a counter.
std::set<std::string> countedOf(const kernels::Shader& shader) {
  std::set<std::string> counted;
  for (const kernels::Kernel& kernel : shader.kernels)
    for (const kernels::Buffer& buffer : kernel.buffers) counted.insert(buffer.counterOf);
  return counted;
}

Json buffersOf(const Memory& memory, const std::set<std::string>& counted) {
  Json buffers = Json::object();
  for (const kernels::Buffer* buffer : memory.buffers) {
    const bool open = !buffer->members.empty() && !buffer->members.back().array.empty() &&
                      buffer->members.back().array[0] == 0;
    if (!open) continue;
    Json start = Json::object();
    for (const kernels::Member& member : buffer->members.back().members)
      if (lowered(member.name).find("pos") != std::string::npos && componentsOf(member.type) == 3)
        start[member.name] = {"random(1)", "random(2)", "random(3)"};
    if (start.empty() || counted.contains(buffer->name))
      buffers[buffer->name] = 1024;
    else
      buffers[buffer->name] = {{"size", 1024}, {"start", start}};
  }
  return buffers;
}

}  // namespace

std::string sceneOf(const kernels::Shader& shader, const std::filesystem::path& file) {
  const Memory memory = memoryOf(shader);
  Json object = {{"file", file.filename().string()}};
  if (const Json buffers = buffersOf(memory, countedOf(shader)); !buffers.empty())
    object["buffers"] = buffers;
  Json textures = Json::object();
  for (const kernels::Texture* texture : memory.textures)
    textures[texture->name] = texture->type == "2D" ? Json{256, 256} : Json{64, 64, 64};
  if (!textures.empty()) object["textures"] = textures;
  Json constants = Json::object();
  Json step = Json::array();
  for (const std::string& name : countedOf(shader))
    if (!name.empty()) step.push_back({{"clear", name + ".counter"}});
  for (const kernels::Kernel& kernel : shader.kernels) {
    step.push_back(kernel.name);
    for (const kernels::Block& block : kernel.blocks)
      for (const kernels::Member& member : block.members)
        if (block.name != "simreel_Samplers" && member.members.empty() && member.used &&
            !isStandard(member))
          constants[member.name] = valueOf(member, memory);
  }
  if (!constants.empty()) object["constants"] = constants;
  object["step"] = step;
  const Json scene = {{"version", 2}, {"objects", {{"mine", {{"kernels", object}}}}}};
  return scene.dump(2) + "\n";
}

}  // namespace simreel::cli

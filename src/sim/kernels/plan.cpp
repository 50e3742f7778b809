#include "sim/kernels/plan.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "gl/shader_source.hpp"
#include "kernels/source/files.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <mutex>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::sim {

namespace {

constexpr const char* lookups[] = {"count", "width", "height", "depth", "quantity"};
constexpr const char* plainNames[] = {"dt", "time", "frame", "steps", "seed", "pi"};

}  // namespace

unsigned PlannedTexture::samplerState(std::string_view sampler) const {
  using Filter = KernelMemory::Filter;
  using Wrap = KernelMemory::Wrap;
  const auto says = [&](const char* word) {
    std::string lower(sampler);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return lower.find(word) != std::string::npos;
  };
  const Filter filter = given == nullptr ? Filter::shader : given->filter;
  const Wrap wrap = given == nullptr ? Wrap::shader : given->wrap;
  const bool linear = filter == Filter::linear || (filter == Filter::shader && !says("point"));
  unsigned mode = 0;
  if (wrap == Wrap::clamp || (wrap == Wrap::shader && says("clamp"))) mode = 1;
  if (wrap == Wrap::mirror || (wrap == Wrap::shader && says("mirror"))) mode = 2;
  return (linear && !integers() ? 1U : 0U) | mode << 2 | mode << 4 | mode << 6;
}

std::shared_ptr<const kernels::Shader> KernelPlan::shaderOf(const kernels::Request& request) {
  struct Known {
    std::shared_ptr<const kernels::Shader> shader;
    std::map<std::string, std::filesystem::file_time_type> files;
  };
  static std::map<std::string, Known> all;
  static std::mutex mutex;
  const std::scoped_lock lock(mutex);
  const std::string key = fmt::format(
      "{} {} {} {} {} {} {} {} {} {} {}", request.file.string(), request.pass, request.upsideDown,
      fmt::join(request.kernels, " "), fmt::join(request.keywords, " "), fmt::join(request.previous, " "),
      request.fast, request.careful, request.maxIterations, static_cast<int>(request.race), request.report);
  const auto changed = [](const Known& known) {
    return std::any_of(known.files.begin(), known.files.end(), [](const auto& file) {
      std::error_code error;
      return std::filesystem::last_write_time(file.first, error) != file.second || error;
    });
  };
  const auto found = all.find(key);
  if (found != all.end() && !changed(found->second)) return found->second.shader;
  Known known{std::make_shared<kernels::Shader>(kernels::load(request)), {}};
  for (const std::string& file : known.shader->files) {
    std::error_code error;
    known.files[file] = std::filesystem::last_write_time(file, error);
  }
  return (all[key] = std::move(known)).shader;
}

KernelPlan::KernelPlan(const KernelDescription& parameters, std::shared_ptr<const kernels::Shader> shader,
                       const std::vector<std::string>& announced,
                       const std::map<std::string, std::string>& aliases)
    : shader_(std::move(shader)),
      aliases_(aliases.begin(), aliases.end()),
      givenBuffers_(parameters.buffers),
      givenTextures_(parameters.textures) {
  for (const kernels::Kernel& kernel : shader_->kernels) {
    for (const kernels::Buffer& buffer : kernel.buffers) collectBuffer(buffer);
    for (const kernels::Texture& texture : kernel.textures) collectTexture(texture);
  }
  holdNames(parameters);
  planConstantFiles(parameters);
  size(parameters);
  if (!mistakes_.empty()) return;
  planConstants(parameters);
  planEntries(parameters.first, "first", announced, 1, first_);
  planEntries(parameters.step, "step", announced, parameters.steps, step_);
  if (parameters.step.empty()) everyKernel();
  planStarts();
  if (mistakes_.empty()) planDrawing(parameters);
  if (mistakes_.empty()) planMeasures(parameters);
}

void KernelPlan::mistake(std::vector<std::string> path, std::string message, std::size_t begin,
                         std::size_t end) {
  mistakes_.push_back({std::move(path), begin, end, std::move(message)});
}

void KernelPlan::unknown(std::vector<std::string> path, const std::string& name,
                         const std::vector<std::string>& known, const std::string& what) {
  mistake(std::move(path), known.empty()
                               ? fmt::format("the shader has no {} {}", what, scene::inQuotes(name))
                               : fmt::format("the shader has no {} {}; {}", what, scene::inQuotes(name),
                                             scene::suggestion(name, known)));
}

bool KernelPlan::mentioned(const std::string& word) const {
  return std::any_of(shader_->files.begin(), shader_->files.end(), [&](const std::string& file) {
    std::string text;
    try {
      text = readFile(file, "shader", kernels::maxFileBytes);
    } catch (const UserError&) {
      return false;
    }
    return gl::mentions(text, word);
  });
}

int KernelPlan::bufferNamed(std::string_view name) const {
  for (std::size_t i = 0; i < buffers_.size(); ++i)
    if (buffers_[i].name == name) return static_cast<int>(i);
  return -1;
}

int KernelPlan::textureNamed(std::string_view name) const {
  if (const auto alias = aliases_.find(name); alias != aliases_.end()) name = alias->second;
  for (std::size_t i = 0; i < textures_.size(); ++i)
    if (textures_[i].name == name) return static_cast<int>(i);
  return -1;
}

void KernelPlan::collectBuffer(const kernels::Buffer& from) {
  PlannedBuffer buffer;
  buffer.name = from.name;
  buffer.counterOf = from.counterOf;
  buffer.guards = from.guards;
  std::vector<kernels::Member> fixed = from.members;
  const bool open = !fixed.empty() && !fixed.back().array.empty() && fixed.back().array[0] == 0;
  if (open) {
    buffer.header = fixed.back().offset;
    buffer.stride = fixed.back().stride;
    buffer.element = slotsOfElement(fixed.back());
    fixed.pop_back();
    buffer.fixed = slotsOf(fixed);
  } else {
    buffer.element = slotsOf(fixed);
    std::size_t end = 4;
    for (const KernelSlot& slot : buffer.element)
      for (const std::size_t offset : slot.offsets) end = std::max(end, offset + slot.width());
    buffer.stride = (end + 15) / 16 * 16;
    buffer.sized = true;
  }
  buffer.previousOf = from.previousOf;
  if (!buffer.counterOf.empty() || !buffer.previousOf.empty()) buffer.sized = true;
  for (const auto* slots : {&buffer.element, &buffer.fixed})
    for (const KernelSlot& slot : *slots)
      buffer.allFloats = buffer.allFloats && slot.number == KernelSlot::Number::real;
  if (const int known = bufferNamed(buffer.name); known >= 0) {
    PlannedBuffer& before = buffers_[static_cast<std::size_t>(known)];
    before.written = before.written || from.writes;
    before.guards = std::max(before.guards, buffer.guards);
    if (before.stride != buffer.stride || before.header != buffer.header)
      mistake({"file"},
              fmt::format("kernels of this file have different elements for the buffer {}: {} and {} bytes",
                          scene::inQuotes(buffer.name), before.stride, buffer.stride));
    return;
  }
  buffer.written = from.writes;
  buffers_.push_back(std::move(buffer));
}

void KernelPlan::collectTexture(const kernels::Texture& from) {
  if (const int known = textureNamed(from.name); known >= 0) {
    PlannedTexture& before = textures_[static_cast<std::size_t>(known)];
    before.written = before.written || from.writes;
    if (!from.format.empty()) before.format = from.format;
    before.formatted = before.formatted || !from.format.empty();
    if (before.type != from.type)
      mistake({"file"}, fmt::format("kernels of this file have the texture {} as {} and as {}",
                                    scene::inQuotes(from.name), before.type, from.type));
    return;
  }
  const auto alias = aliases_.find(from.name);
  PlannedTexture texture{alias == aliases_.end() ? from.name : alias->second, from.type, from.format};
  texture.written = from.writes;
  texture.values = from.values;
  texture.formatted = !from.format.empty();
  if (from.type.ends_with(']'))
    mistake({"file"},
            fmt::format("{} is an array of textures, {}; a scene sets single ones: give each a name, "
                        "or use a Texture2DArray",
                        scene::inQuotes(from.name), from.type));
  else if (from.type != "2D" && from.type != "3D" && from.type != "2DArray" && from.type != "Cube")
    mistake({"file"},
            fmt::format(
                "the texture {} is of the kind {}; scenes have those of the kinds 2D, 3D, 2DArray and Cube",
                scene::inQuotes(from.name), from.type));
  if (texture.format.empty())
    texture.format = from.values == "int" ? "rgba32i" : from.values == "uint" ? "rgba32ui" : "rgba32f";
  textures_.push_back(std::move(texture));
}

int KernelPlan::placeOfLookup(const std::string& name, double value) {
  std::size_t at = 0;
  while (at < lookups_.size() && lookups_[at].first != name) ++at;
  if (at == lookups_.size()) lookups_.emplace_back(name, value);
  return static_cast<int>(std::size(plainNames) + at);
}

int KernelPlan::placeInConstant(const std::string& name) {
  if (planned_ == nullptr) return -1;
  if (planned_->table != nullptr) {
    const std::vector<std::string>& columns = planned_->table->columns;
    const auto column = std::find(columns.begin(), columns.end(), name);
    if (column != columns.end()) {
      const int place = placeOfLookup(fmt::format("{} {}", plannedName_, name), 0);
      planned_->columns.emplace_back(place, column - columns.begin());
      return place;
    }
  }
  if (name != "i") return -1;
  planned_->counts = true;
  // No formula can contain the blank, so that i is unknown outside constants.
  return planned_->countPlace = placeOfLookup("constant i", 0);
}

int KernelPlan::placeOf(const std::string& name) {
  if (const int place = placeInConstant(name); place >= 0) return place;
  for (std::size_t i = 0; i < std::size(plainNames); ++i)
    if (name == plainNames[i]) return static_cast<int>(i);
  for (std::size_t i = 0; i < lookups_.size(); ++i)
    if (name == lookups_[i].first) return static_cast<int>(std::size(plainNames) + i);
  const std::size_t open = name.find('(');
  if (open == std::string::npos) return -1;
  const std::string function = name.substr(0, open), memory = name.substr(open + 1, name.size() - open - 2);
  if (function == "quantity") {
    if (planned_ == nullptr || memory.find('.') == std::string::npos) return -1;
    quantities_.push_back({memory, {}});
    quantityPlaces_.push_back(lookups_.size());
    return placeOfLookup(name, 0);
  }
  const int buffer = bufferNamed(memory), texture = textureNamed(memory);
  if (buffer < 0 && texture < 0) {
    const auto constant = constants_.find(memory);
    if (function != "count" || constant == constants_.end() || constant->second.table == nullptr) return -1;
    return placeOfLookup(name, static_cast<double>(constant->second.table->rows()));
  }
  const bool sized = buffer >= 0 ? buffers_[static_cast<std::size_t>(buffer)].sized
                                 : textures_[static_cast<std::size_t>(texture)].sized;
  if (!sized) return -1;
  const glm::ivec3 size = buffer >= 0 ? buffers_[static_cast<std::size_t>(buffer)].size
                                      : textures_[static_cast<std::size_t>(texture)].size;
  return placeOfLookup(name, function == "count"    ? 1.0 * size.x * size.y * size.z
                             : function == "width"  ? size.x
                             : function == "height" ? size.y
                                                    : size.z);
}

std::string KernelPlan::unsizedIn(const std::string& name) const {
  const std::size_t open = name.find('(');
  if (open == std::string::npos || !name.ends_with(')')) return {};
  const std::string memory = name.substr(open + 1, name.size() - open - 2);
  return bufferNamed(memory) >= 0 || textureNamed(memory) >= 0 ? memory : "";
}

PlannedNumber KernelPlan::compiled(const scene::Formula::Part& part, std::vector<std::string> path) {
  if (part.text.empty()) return {part.number, nullptr};
  std::vector<std::string> known(std::begin(plainNames), std::end(plainNames));
  for (const PlannedBuffer& buffer : buffers_) known.push_back(fmt::format("count({})", buffer.name));
  for (const PlannedTexture& texture : textures_) known.push_back(fmt::format("width({})", texture.name));
  if (planned_ != nullptr) known.emplace_back("i");
  if (planned_ != nullptr && planned_->table != nullptr)
    known.insert(known.end(), planned_->table->columns.begin(), planned_->table->columns.end());
  const std::size_t quantitiesBefore = quantities_.size();
  try {
    PlannedNumber made{
        0, std::make_shared<Expression>(
               part.text, [this](const std::string& name) { return placeOf(name); }, known, lookups)};
    for (std::size_t i = quantitiesBefore; i < quantities_.size(); ++i) quantities_[i].path = path;
    return made;
  } catch (const scene::ExpressionMistake& wrong) {
    if (part.text.substr(wrong.begin).starts_with("quantity(")) {
      mistake(std::move(path),
              planned_ != nullptr
                  ? "a quantity has the name of an object and its own: quantity(OBJECT.QUANTITY)"
                  : "only constants use quantities of objects, which change from frame to frame",
              wrong.begin, wrong.end);
      return {};
    }
    const std::string circle = unsizedIn(part.text.substr(wrong.begin, wrong.end - wrong.begin));
    mistake(
        std::move(path),
        circle.empty()
            ? wrong.message
            : fmt::format("the size of {} is not known here; sizes cannot depend on each other in a circle",
                          circle),
        wrong.begin, wrong.end);
    return {};
  }
}

std::vector<double> KernelPlan::values(const Now& now) const {
  std::vector<double> all = {now.dt,
                             now.time,
                             static_cast<double>(now.frame),
                             static_cast<double>(now.step),
                             static_cast<double>(now.seed),
                             3.14159265358979323846};
  for (const auto& [name, value] : lookups_) all.push_back(value);
  for (std::size_t i = 0; i < std::min(now.quantities.size(), quantityPlaces_.size()); ++i)
    all[std::size(plainNames) + quantityPlaces_[i]] = now.quantities[i];
  return all;
}

}  // namespace simreel::sim

// The part of KernelPlan that computes constants and the contents of uniform blocks.
#include "base/error.hpp"
#include "gl/shader_source.hpp"
#include "scene/json/words.hpp"
#include "sim/kernels/plan.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <set>
#include <string_view>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Default values of Unity's constants.
struct Standard {
  const char* name;
  std::vector<const char*> parts;
};
const std::vector<Standard>& standards() {
  static const std::vector<Standard> list = {
      {"_Time", {"time / 20", "time", "time * 2", "time * 3"}},
      {"_SinTime", {"sin(time / 8)", "sin(time / 4)", "sin(time / 2)", "sin(time)"}},
      {"_CosTime", {"cos(time / 8)", "cos(time / 4)", "cos(time / 2)", "cos(time)"}},
      {"unity_DeltaTime", {"dt", "1 / dt", "dt", "1 / dt"}},
  };
  return list;
}

/// Bytes of a uniform block that every device with OpenGL 4.5 in use accepts.
constexpr std::size_t mostBlockBytes = 65536;

/// Path of a constant without the index of its struct: "lights[3].color" becomes "lights.color" and 3.
/// Paths with no index or several are unchanged.
struct ArrayPath {
  std::string path;
  std::size_t element = 0;
  bool isInArray = false;

  explicit ArrayPath(const std::string& full) : path(full) {
    const std::size_t open = full.find('['), close = full.find(']');
    if (close == std::string::npos || full.find('[', open + 1) != std::string::npos) return;
    std::from_chars(full.data() + open + 1, full.data() + close, element);
    path = full.substr(0, open) + full.substr(close + 1);
    isInArray = true;
  }
};

/// Returns true if the value of an expression may differ between dispatches.
bool changes(const std::string& expression) {
  constexpr const char* words[] = {"dt", "time", "frame", "steps", "seed", "random", "quantity"};
  return std::any_of(std::begin(words), std::end(words),
                     [&](const char* word) { return gl::mentions(expression, word); });
}

bool isSamplerBlock(const kernels::Block& block) {
  return block.name == "simreel_Samplers";
}

}  // namespace

void KernelPlan::planConstantFiles(const KernelDescription& parameters) {
  for (const KernelConstantFile& given : parameters.constantFiles) {
    const std::vector<std::string> path = {"constantFiles", given.name, "file"};
    if (given.file.empty()) {
      mistake(path, "give the file of the constant's numbers");
      continue;
    }
    try {
      constants_[given.name].table = &tables_.of(given.file);
    } catch (const UserError& error) {
      mistake(path, error.what());
    }
  }
}

void KernelPlan::planConstants(const KernelDescription& parameters) {
  for (const scene::Formulas::Named& given : parameters.constants.list) {
    planned_ = &constants_[given.name];
    plannedName_ = given.name;
    planned_->moving = given.formula.moving;
    planned_->width = given.formula.components();
    for (std::size_t i = 0; i < given.formula.parts.size(); ++i) {
      std::vector<std::string> path = {"constants", given.name};
      if (given.formula.parts.size() > 1) path.push_back(std::to_string(i));
      planned_->parts.push_back(compiled(given.formula.parts[i], std::move(path)));
      planned_->changes = planned_->changes || changes(given.formula.parts[i].text);
    }
  }
  for (auto& [name, constant] : constants_) {
    if (constant.table == nullptr || constant.width != 0) continue;
    planned_ = &constant;
    plannedName_ = name;
    for (const std::string& column : constant.table->columns)
      constant.parts.push_back(compiled({0, column}, {"constantFiles", name}));
    constant.width = constant.parts.size();
    constant.fromFile = true;
  }
  planned_ = nullptr;
  holdConstants();
}

KernelPlan::Found KernelPlan::constantOf(const std::string& path) const {
  const auto exact = constants_.find(path);
  if (exact != constants_.end()) return {&exact->second, 0};
  const ArrayPath member(path);
  const auto whole = member.isInArray ? constants_.find(member.path) : constants_.end();
  return whole == constants_.end() ? Found{} : Found{&whole->second, member.element};
}

void KernelPlan::holdConstants() {
  std::set<std::string> paths, members;
  for (const kernels::Kernel& kernel : shader_->kernels)
    for (const kernels::Block& block : kernel.blocks)
      if (!isSamplerBlock(block))
        for (const std::string& path : pathsOf(slotsOf(block.members))) {
          paths.insert(path);
          members.insert(ArrayPath(path).path);
        }
  const std::vector<std::string> known(members.begin(), members.end());
  for (const auto& [name, constant] : constants_)
    if (!paths.contains(name) && !members.contains(name) && !mentioned(name))
      unknown({constant.parts.empty() ? "constantFiles" : "constants", name}, name, known, "constant");
  std::set<std::string> used;
  for (const kernels::Kernel& kernel : shader_->kernels)
    for (const kernels::Block& block : kernel.blocks)
      if (!isSamplerBlock(block)) holdBlock(kernel, block, used);
}

/// Checks the constants of a block. `used` holds the constants that kernels read.
void KernelPlan::holdBlock(const kernels::Kernel& kernel, const kernels::Block& block,
                           std::set<std::string>& used) {
  if (block.bytes > mostBlockBytes)
    return mistake({"file"}, fmt::format("the constants of kernel {} take {} bytes; a uniform block holds "
                                         "{}: make the largest array a StructuredBuffer",
                                         scene::inQuotes(kernel.name), block.bytes, mostBlockBytes));
  const std::vector<KernelSlot> slots = slotsOf(block.members);
  std::map<std::string, std::size_t> lengths;  // of arrays of structs, by path without index
  for (const KernelSlot& slot : slots) ++lengths[ArrayPath(slot.path).path];
  for (const KernelSlot& slot : slots) {
    const auto standard = std::find_if(standards().begin(), standards().end(), [&](const Standard& s) {
      return slot.path == s.name && slot.offsets.size() == s.parts.size();
    });
    if (!constants_.contains(slot.path) && standard != standards().end()) {
      Constant& constant = constants_[slot.path];
      for (const char* part : standard->parts) constant.parts.push_back(compiled({0, part}, {}));
      constant.width = constant.parts.size();
    }
    const ArrayPath member(slot.path);
    if (constantOf(slot.path).constant == nullptr) {
      if (slot.used && used.insert(member.path).second)
        mistake({"constants"}, fmt::format("kernel {} reads the constant {} ({}), which has no value; "
                                           "give \"constants\": {{\"{}\": ...}}",
                                           scene::inQuotes(kernel.name), scene::inQuotes(slot.path),
                                           slot.type, member.path));
      continue;
    }
    if (const auto exact = constants_.find(slot.path); exact != constants_.end())
      holdConstant(exact->second, slot.path, slot, slot.elements);
    else if (used.insert(member.path).second)
      holdConstant(constants_.at(member.path), member.path, slot, lengths.at(member.path) * slot.elements);
  }
}

/// Checks how many numbers a constant has. `elements` is the length of the array.
void KernelPlan::holdConstant(Constant& constant, const std::string& name, const KernelSlot& slot,
                              std::size_t elements) {
  const std::size_t each = slot.offsets.size() / slot.elements;
  const char* key = constant.fromFile ? "constantFiles" : "constants";
  const auto expected = [&] {
    return slot.elements == 1
               ? fmt::format("{} number(s)", each)
               : fmt::format("{} numbers, or {} for each element", slot.offsets.size(), each);
  };
  if (constant.width != slot.offsets.size() && constant.width != each && constant.width != 1)
    return mistake(
        {key, name},
        fmt::format("{} is a {}: expected {}, found {}{}", scene::inQuotes(name), slot.type, expected(),
                    constant.width, constant.fromFile ? " columns; name some in \"constants\"" : ""));
  if (constant.counts && elements == 1)
    return mistake({key, name}, fmt::format("i counts the elements of an array; {} is a {}",
                                            scene::inQuotes(name), slot.type));
  if (constant.table != nullptr && constant.table->rows() > elements)
    return mistake({"constantFiles", name},
                   fmt::format("the file has {} rows; {} is a {} of {} element(s)", constant.table->rows(),
                               scene::inQuotes(name), slot.type, elements));
  for (const PlannedNumber& part : constant.parts)
    if (const std::string problem = whyTooLarge(slot, part.number);
        part.expression == nullptr && !problem.empty())
      return mistake({key, name}, problem);
  if (constant.changes || slot.elements == 1 || elements != slot.elements ||
      (!constant.counts && constant.columns.empty()))
    return;
  // Formulas of a large array that never change are evaluated once, not for each dispatch.
  std::vector<double> all = values({});
  std::vector<PlannedNumber> numbers;
  for (std::size_t i = 0; i < slot.offsets.size(); ++i)
    numbers.push_back({numberOf({&constant, 0}, slot, i, {}, all), nullptr});
  constant.parts = std::move(numbers);
  constant.width = slot.offsets.size();
  constant.columns.clear();
  constant.counts = false;
}

std::vector<std::byte> KernelPlan::blockBytes(const kernels::Block& block, const Now& now) const {
  std::vector<std::byte> bytes(block.bytes);
  if (isSamplerBlock(block)) {
    for (KernelSlot slot : slotsOf(block.members)) {
      const PlannedTexture* read = nullptr;
      if (const auto alias = aliases_.find(slot.path); alias != aliases_.end()) slot.path = alias->second;
      for (const PlannedTexture& texture : textures_)
        if ((slot.path == texture.name || slot.path.starts_with(texture.name + "_")) &&
            (read == nullptr || read->name.size() < texture.name.size()))
          read = &texture;
      if (read != nullptr)
        storeSlot(bytes.data(), slot, 0,
                  read->samplerState(std::string_view(slot.path).substr(read->name.size())));
    }
    return bytes;
  }
  std::vector<double> all = values(now);
  for (const KernelSlot& slot : slotsOf(block.members)) {
    const Found found = constantOf(slot.path);
    if (found.constant == nullptr) continue;
    for (std::size_t i = 0; i < slot.offsets.size(); ++i)
      storeSlot(bytes.data(), slot, i, numberOf(found, slot, i, now, all));
  }
  return bytes;
}

/// Returns component `i` of a slot. Sets the values in `all` that depend on the element.
double KernelPlan::numberOf(const Found& found, const KernelSlot& slot, std::size_t i, const Now& now,
                            std::vector<double>& all) const {
  const Constant& constant = *found.constant;
  const std::size_t each = slot.offsets.size() / slot.elements;
  const std::size_t element = found.element * slot.elements + i / each;
  const std::size_t part = constant.width == 1 ? 0 : constant.width == each ? i % each : i;
  if (constant.moving)
    return static_cast<double>(constant.moving->at(now.time)[static_cast<glm::length_t>(part)]);
  const PlannedNumber& number = constant.parts[part];
  if (!number.expression) return number.number;
  if (constant.countPlace >= 0)
    all[static_cast<std::size_t>(constant.countPlace)] = static_cast<double>(element);
  for (const auto& [place, column] : constant.columns) {
    const std::size_t at = element * constant.table->columns.size() + column;
    all[place] = element < constant.table->rows() ? constant.table->values[at] : 0;
  }
  return number.expression->at(all, static_cast<std::uint32_t>(element),
                               static_cast<std::uint32_t>(now.seed));
}

}  // namespace simreel::sim

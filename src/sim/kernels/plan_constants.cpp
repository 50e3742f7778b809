// The part of KernelPlan that computes constants and the contents of uniform blocks.
#include "scene/json/words.hpp"
#include "sim/kernels/plan.hpp"

#include <algorithm>
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

bool isSamplerBlock(const kernels::Block& block) {
  return block.name == "simreel_Samplers";
}

}  // namespace

void KernelPlan::planConstants(const KernelDescription& parameters) {
  takesQuantities_ = true;
  for (const scene::Formulas::Named& given : parameters.constants.list) {
    Constant constant;
    constant.moving = given.formula.moving;
    constant.width = static_cast<int>(given.formula.components());
    for (std::size_t i = 0; i < given.formula.parts.size(); ++i) {
      std::vector<std::string> path = {"constants", given.name};
      if (given.formula.parts.size() > 1) path.push_back(std::to_string(i));
      constant.parts.push_back(compiled(given.formula.parts[i], std::move(path)));
    }
    constants_[given.name] = std::move(constant);
  }
  takesQuantities_ = false;
  holdConstants();
}

void KernelPlan::holdConstants() {
  std::set<std::string> used;
  std::vector<std::string> known;
  for (const kernels::Kernel& kernel : shader_->kernels)
    for (const kernels::Block& block : kernel.blocks)
      if (!isSamplerBlock(block))
        for (const std::string& name : pathsOf(slotsOf(block.members))) known.push_back(name);
  for (const auto& [name, constant] : constants_)
    if (std::find(known.begin(), known.end(), name) == known.end() && !mentioned(name))
      unknown({"constants", name}, name, known, "constant");
  for (const kernels::Kernel& kernel : shader_->kernels)
    for (const kernels::Block& block : kernel.blocks) {
      if (isSamplerBlock(block)) continue;
      const std::vector<KernelSlot> slots = slotsOf(block.members);
      for (const KernelSlot& slot : slots) {
        const auto standard = std::find_if(standards().begin(), standards().end(), [&](const Standard& s) {
          return slot.path == s.name && slot.offsets.size() == s.parts.size();
        });
        if (!constants_.contains(slot.path) && standard != standards().end()) {
          Constant& constant = constants_[slot.path];
          for (const char* part : standard->parts) constant.parts.push_back(compiled({0, part}, {}));
          constant.width = static_cast<int>(constant.parts.size());
        }
        const auto found = constants_.find(slot.path);
        if (found == constants_.end()) {
          if (slot.used && used.insert(slot.path).second)
            mistake({"constants"}, fmt::format("kernel {} reads the constant {} ({}), which has no value; "
                                               "give \"constants\": {{\"{}\": ...}}",
                                               scene::inQuotes(kernel.name), scene::inQuotes(slot.path),
                                               slot.type, slot.path));
          continue;
        }
        used.insert(slot.path);
        const auto width = static_cast<std::size_t>(found->second.width);
        if (width != slot.offsets.size() && width != 1)
          mistake({"constants", slot.path},
                  fmt::format("{} is a {}: expected {} number(s), found {}", scene::inQuotes(slot.path),
                              slot.type, slot.offsets.size(), width));
        for (const PlannedNumber& part : found->second.parts)
          if (const std::string problem = whyTooLarge(slot, part.number);
              part.expression == nullptr && !problem.empty())
            mistake({"constants", slot.path}, problem);
      }
    }
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
  const std::vector<double> all = values(now);
  for (const KernelSlot& slot : slotsOf(block.members)) {
    const auto found = constants_.find(slot.path);
    if (found == constants_.end()) continue;
    const Constant& constant = found->second;
    const glm::vec4 moved = constant.moving ? constant.moving->at(now.time) : glm::vec4(0);
    for (std::size_t i = 0; i < slot.offsets.size(); ++i) {
      const std::size_t part = constant.width == 1 ? 0 : i;
      const double value = constant.moving ? static_cast<double>(moved[static_cast<int>(part)])
                           : constant.parts[part].expression ? constant.parts[part].expression->at(all)
                                                             : constant.parts[part].number;
      storeSlot(bytes.data(), slot, i, value);
    }
  }
  return bytes;
}

}  // namespace simreel::sim

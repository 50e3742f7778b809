#include "kernels/guards/place.hpp"

#include "kernels/compile/messages.hpp"
#include "kernels/spirv/resource.hpp"

namespace simreel::kernels {

void Position::follow(const Module& module, const Files& files, const Instruction& one) {
  if (one.op == SpvOpFunction) line = 0;
  if (one.op != SpvOpLine) return;
  file = fileNumber(module.text(one.operands[0]), files.count());
  line = static_cast<int>(one.operands[1]);
}

void repeatLines(Module& module) {
  std::vector<Instruction> body;
  body.reserve(module.body.size() * 5 / 4);
  Instruction last;
  for (Instruction& one : module.body) {
    const bool begins = one.op == SpvOpLabel;
    if (one.op == SpvOpLine) last = one;
    body.push_back(std::move(one));
    if (begins && last.op == SpvOpLine) body.push_back(last);
  }
  module.body = std::move(body);
}

std::string indexedName(const Module& module, Id variable, std::span<const Id> indices) {
  // Removes generated suffixes, which start with a dot. A user's name cannot contain a dot.
  std::string name = plainName(module.name(variable));
  name = name.substr(0, name.find('.'));
  Id type = module.global(module.typeOf(variable))->operands[1];
  for (std::size_t i = 0; i + 1 < indices.size(); ++i) {
    const Instruction& made = *module.global(type);
    if (made.op != SpvOpTypeStruct) {
      type = made.operands[0];
      continue;
    }
    const std::uint32_t member = module.constant(indices[i]).value_or(0);
    // An HLSL buffer stores its elements in a member "@data".
    if (const std::string found = module.memberName(type, member); !found.empty() && found[0] != '@')
      name = found;
    type = made.operands[member];
  }
  return name.empty() || name == "indexable" ? "an array" : name;
}

}  // namespace simreel::kernels

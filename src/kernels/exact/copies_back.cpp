#include "kernels/exact/copies_back.hpp"

#include "kernels/guards/place.hpp"

#include <optional>
#include <unordered_map>
#include <utility>

namespace simreel::kernels {

namespace {

/// Returns the inverse of a conversion, or nullopt for other operations.
std::optional<SpvOp> inverse(SpvOp op) {
  switch (op) {
    case SpvOpConvertSToF:
      return SpvOpConvertFToS;
    case SpvOpConvertUToF:
      return SpvOpConvertFToU;
    case SpvOpConvertFToS:
      return SpvOpConvertSToF;
    case SpvOpConvertFToU:
      return SpvOpConvertUToF;
    case SpvOpBitcast:
      return SpvOpBitcast;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::vector<Mistake> copyBack(Module& module, const Files& files) {
  std::unordered_map<Id, Instruction> made;  // conversions and loads of the current function by result id
  std::vector<Mistake> mistakes;
  std::vector<Instruction> body = std::move(module.body);
  module.body.clear();
  Position position;
  for (Instruction& one : body) {
    if (one.op == SpvOpFunctionEnd) made.clear();
    position.follow(module, files, one);
    if (inverse(one.op) || one.op == SpvOpLoad) made.emplace(one.result, one);
    const auto target = one.op == SpvOpStore ? made.find(one.operands[0]) : made.end();
    if (target == made.end() || target->second.op == SpvOpLoad) {
      module.body.push_back(std::move(one));
      continue;
    }
    const auto from = made.find(target->second.operands[0]);
    if (from == made.end() || from->second.op != SpvOpLoad) {
      mistakes.push_back({position.file,
                          position.line,
                          {},
                          "an argument for an inout parameter has another type, and is no "
                          "variable; give a variable of the parameter's type"});
      continue;
    }
    const Id back = module.fresh();
    module.noteType(back, from->second.type);
    module.body.push_back({*inverse(target->second.op), from->second.type, back, {one.operands[1]}});
    module.body.push_back({SpvOpStore, 0, 0, {from->second.operands[0], back}});
  }
  return mistakes;
}

}  // namespace simreel::kernels

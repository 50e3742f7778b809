#include "kernels/exact/room.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace simreel::kernels {

namespace {

class Enlarging {
 public:
  explicit Enlarging(Module& module) : module_(module) {}

  std::unordered_map<Id, std::uint32_t> run() {
    constexpr std::uint32_t maximum = 32768;
    std::uint32_t bytes = 0;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < module_.globals.size(); ++i) {
      const Instruction& one = module_.globals[i];
      if (one.op != SpvOpVariable || one.operands[0] != SpvStorageClassWorkgroup) continue;
      const Id type = typeMaking(one.type).operands[1];
      bytes += sizeOf(type);
      if (typeMaking(type).op == SpvOpTypeArray) found.push_back(i);
    }
    for (const std::size_t i : found) {
      const Instruction variable = module_.globals[i];
      const Instruction array = typeMaking(typeMaking(variable.type).operands[1]);
      const auto length = module_.constant(array.operands[1]);
      const std::uint32_t element = sizeOf(array.operands[0]);
      if (!length || bytes + element > maximum || usedWhole(variable.result)) continue;
      bytes += element;
      const Id longer =
          module_.addGlobal(SpvOpTypeArray, 0, {array.operands[0], module_.uintConstant(*length + 1)});
      const Id pointer = module_.globalOf(SpvOpTypePointer, 0, {SpvStorageClassWorkgroup, longer});
      shared_[variable.result] = *length;
      retyped_.emplace_back(variable.result, pointer);
    }
    // Moves variables to the end, because types must precede their uses.
    for (const auto& one : retyped_) {
      const Id variable = one.first, pointer = one.second;
      const auto at = std::find_if(module_.globals.begin(), module_.globals.end(),
                                   [&](const Instruction& made) { return made.result == variable; });
      Instruction moved = *at;
      moved.type = pointer;
      module_.globals.erase(at);
      module_.globals.push_back(std::move(moved));
      module_.index();
    }
    return std::move(shared_);
  }

 private:
  const Instruction& typeMaking(Id type) const { return *module_.global(type); }

  bool usedWhole(Id variable) const {
    return std::any_of(module_.body.begin(), module_.body.end(), [&](const Instruction& one) {
      if (one.op == SpvOpAccessChain || one.op == SpvOpInBoundsAccessChain) return false;
      for (std::size_t i = 0; i < one.operands.size(); ++i)
        if (one.operands[i] == variable && isId(one, i)) return true;
      return false;
    });
  }

  std::uint32_t sizeOf(Id type) const {
    const Instruction& made = typeMaking(type);
    switch (made.op) {
      case SpvOpTypeVector:
      case SpvOpTypeMatrix:
        return made.operands[1] * sizeOf(made.operands[0]);
      case SpvOpTypeArray:
        return module_.constant(made.operands[1]).value_or(1) * sizeOf(made.operands[0]);
      case SpvOpTypeStruct: {
        std::uint32_t sum = 0;
        for (const Id member : made.operands) sum += sizeOf(member);
        return sum;
      }
      default:
        return 4;
    }
  }

  Module& module_;
  std::unordered_map<Id, std::uint32_t> shared_;
  std::vector<std::pair<Id, Id>> retyped_;
};

}  // namespace

std::unordered_map<Id, std::uint32_t> enlargeShared(Module& module) {
  return Enlarging(module).run();
}

}  // namespace simreel::kernels

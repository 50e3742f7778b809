#include "kernels/guards/previous.hpp"

#include "kernels/guards/place.hpp"
#include "kernels/spirv/resource.hpp"
#include "kernels/spirv/writing.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

bool isChain(SpvOp op) {
  return op == SpvOpAccessChain || op == SpvOpInBoundsAccessChain;
}

class Previous {
 public:
  Previous(Module& module, const Files& files, bool hlsl, const std::vector<std::string>& names)
      : module_(module), files_(files), hlsl_(hlsl), names_(names) {}

  std::vector<Mistake> run() {
    choose();
    if (twins_.empty()) return {};
    std::vector<Instruction> body = std::move(module_.body);
    module_.body.clear();
    for (Instruction& one : body) {
      at_.follow(module_, files_, one);
      place(one);
    }
    module_.index();
    return std::move(mistakes_);
  }

 private:
  /// Creates a twin for each named buffer that is both read and written. The twin is the copy with the
  /// previous state.
  void choose() {
    std::unordered_map<Id, Id> from;
    std::unordered_map<Id, unsigned> uses;  // Bit 0 is set if a variable is read, and bit 1 if it is
                                            // written.
    const auto root = [&](Id id) {
      const auto found = from.find(id);
      return found == from.end() ? id : found->second;
    };
    for (const Instruction& one : module_.body) {
      if (isChain(one.op)) from[one.result] = root(one.operands[0]);
      if (one.op == SpvOpLoad) uses[root(one.operands[0])] |= 1U;
      if (one.op == SpvOpStore) uses[root(one.operands[0])] |= 2U;
      if (isAtomic(one.op)) uses[root(one.operands[0])] |= one.op == SpvOpAtomicStore ? 2U : 3U;
    }
    const std::vector<Instruction> globals = module_.globals;
    for (const Instruction& one : globals)
      if (resourceOf(module_, one) == Resource::storage && !isArrayed(module_, one) &&
          uses[one.result] == 3U &&
          std::find(names_.begin(), names_.end(), bufferName(module_, one.result, hlsl_)) != names_.end())
        twins_[one.result] = twin(one);
  }

  static bool isAtomic(SpvOp op) { return op >= SpvOpAtomicLoad && op <= SpvOpAtomicXor; }

  /// Creates a variable for a separate block with the same members.
  Id twin(const Instruction& variable) {
    const Instruction type = resourceType(module_, variable);
    const std::string name = bufferName(module_, variable.result, hlsl_) + previousSuffix;
    const Id block = module_.addGlobal(SpvOpTypeStruct, 0, type.operands);
    const std::vector<Instruction> decorations = module_.decorations;
    for (Instruction one : decorations)
      if (one.operands[0] == type.result) {
        one.operands[0] = block;
        module_.decorations.push_back(std::move(one));
      }
    for (std::uint32_t i = 0; i < type.operands.size(); ++i)
      giveMemberName(module_, block, i, module_.memberName(type.result, i));
    const Id pointer = module_.globalOf(SpvOpTypePointer, 0, {variable.operands[0], block});
    const Id made = module_.addGlobal(SpvOpVariable, pointer, {variable.operands[0]});
    giveName(module_, block, name);
    giveName(module_, made, name);
    return made;
  }

  void place(Instruction& one) {
    const auto twin = one.operands.empty() ? twins_.end() : twins_.find(one.operands[0]);
    if (twin == twins_.end()) {
      module_.body.push_back(std::move(one));
      return;
    }
    if (isChain(one.op)) {
      Instruction other = one;
      other.operands[0] = twin->second;
      other.result = module_.fresh();
      twins_[one.result] = other.result;
      module_.noteType(other.result, other.type);
      module_.body.push_back(std::move(other));
    }
    if (one.op == SpvOpLoad) one.operands[0] = twin->second;
    if (isAtomic(one.op)) refuse(one);
    module_.body.push_back(std::move(one));
  }

  void refuse(const Instruction& atomic) {
    Id pointer = atomic.operands[0];
    for (std::size_t i = module_.body.size(); i-- > 0;)
      if (isChain(module_.body[i].op) && module_.body[i].result == pointer)
        pointer = module_.body[i].operands[0];
    const std::string name = bufferName(module_, pointer, hlsl_);
    mistakes_.push_back(
        {at_.file, at_.line, name,
         fmt::format("an atomic operation works on the present state, and the kernel reads {} as it was "
                     "before the dispatch; count in another buffer, or leave {} out of \"previous\"",
                     scene::inQuotes(name), scene::inQuotes(name))});
  }

  Module& module_;
  const Files& files_;
  bool hlsl_;
  const std::vector<std::string>& names_;
  std::unordered_map<Id, Id> twins_;  ///< twins of variables and of access chains, by the original's id
  Position at_;
  std::vector<Mistake> mistakes_;
};

}  // namespace

std::vector<Mistake> readPrevious(Module& module, const Files& files, bool hlsl,
                                  const std::vector<std::string>& names) {
  return Previous(module, files, hlsl, names).run();
}

}  // namespace simreel::kernels

#include "kernels/exact/bounds.hpp"

#include "kernels/spirv/resource.hpp"

#include <GLSL.std.450.h>
#include <algorithm>
#include <unordered_map>
#include <utility>

namespace simreel::kernels {

namespace {

/// A chain of pointers, from its variable on.
struct Chain {
  Id base = 0;
  Words indices;
};
/// Replacement of an access chain that an index could lead out of bounds. Its own id is the place to read.
struct Guarded {
  Id inside = 0;       ///< whether all indices are; 0 where a guard element answers in place of it
  Id condition = 0;    ///< the same, for results of atomic operations
  Id write = 0;        ///< where to write, and what atomic operations work on
  bool drops = false;  ///< whether `write` leads to where nothing is lost
};

class Bounds {
 public:
  explicit Bounds(Module& module) : module_(module), set_(module.extendedSet()) {}

  void run() {
    enlargeShared();
    std::vector<Instruction> body = std::move(module_.body);
    module_.body.clear();
    for (const Instruction& one : body) noteUse(one);
    for (Instruction& one : body) place(one);
    if (queries_)
      module_.head.insert(module_.head.begin(), {SpvOpCapability, 0, 0, {SpvCapabilityImageQuery}});
    module_.index();
  }

 private:
  Id emit(SpvOp op, Id type, Words operands) {
    const Id made = module_.fresh();
    module_.noteType(made, type);
    module_.body.push_back({op, type, made, std::move(operands)});
    return made;
  }
  Id least(Id a, Id b) { return emit(SpvOpExtInst, module_.uintType(), {set_, GLSLstd450UMin, a, b}); }
  Id both(Id a, Id b) {
    return a == 0 ? b : b == 0 ? a : emit(SpvOpLogicalAnd, module_.boolType(), {a, b});
  }
  Id asUint(Id value) {
    if (const auto constant = module_.constant(value)) return module_.uintConstant(*constant);
    return module_.typeOf(value) == module_.uintType() ? value
                                                       : emit(SpvOpBitcast, module_.uintType(), {value});
  }
  Id zero(Id type) { return module_.globalOf(SpvOpConstantNull, type, {}); }
  const Instruction& typeMaking(Id type) const { return *module_.global(type); }

  bool selectable(Id type) const {
    const SpvOp op = typeMaking(type).op;
    return op == SpvOpTypeFloat || op == SpvOpTypeInt || op == SpvOpTypeBool || op == SpvOpTypeVector;
  }
  /// `a` where the condition holds, `b` elsewhere; `result`: an id that is there already.
  Id select(Id condition, Id type, Id a, Id b, Id result = 0) {
    if (const Instruction made = typeMaking(type); made.op == SpvOpTypeVector) {
      const Id wide = module_.vectorType(module_.boolType(), made.operands[1]);
      condition = emit(SpvOpCompositeConstruct, wide, Words(made.operands[1], condition));
    }
    if (result == 0) return emit(SpvOpSelect, type, {condition, a, b});
    module_.body.push_back({SpvOpSelect, type, result, {condition, a, b}});
    return result;
  }

  /// Arrays in shared memory get an element that takes dropped writes, while there is room.
  void enlargeShared() {
    constexpr std::uint32_t most = 32768;
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
      if (!length || bytes + element > most || usedWhole(variable.result)) continue;
      bytes += element;
      const Id longer =
          module_.addGlobal(SpvOpTypeArray, 0, {array.operands[0], module_.uintConstant(*length + 1)});
      const Id pointer = module_.globalOf(SpvOpTypePointer, 0, {SpvStorageClassWorkgroup, longer});
      shared_[variable.result] = *length;
      retyped_.emplace_back(variable.result, pointer);
    }
    // Types stand before what uses them.
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
  }

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

  /// Uses of each pointer, apart from chains that go on from it.
  void noteUse(const Instruction& one) {
    if (one.op == SpvOpAccessChain || one.op == SpvOpInBoundsAccessChain) return;
    if (one.op == SpvOpStore || (one.op >= SpvOpAtomicLoad && one.op <= SpvOpAtomicXor)) {
      uses_[one.operands[0]].writes = true;
      return;
    }
    for (std::size_t i = 0; i < one.operands.size(); ++i)
      if (isId(one, i)) uses_[one.operands[i]].reads = true;
  }

  void place(Instruction& one) {
    switch (one.op) {
      case SpvOpAccessChain:
      case SpvOpInBoundsAccessChain:
        return chain(one);
      case SpvOpLoad:
        return load(one);
      case SpvOpStore:
        return store(one);
      case SpvOpArrayLength: {
        const Id whole = emit(SpvOpArrayLength, one.type, one.operands);
        module_.body.push_back(
            {SpvOpISub, one.type, one.result, {whole, module_.uintConstant(guardElements)}});
        return;
      }
      case SpvOpVectorExtractDynamic:
      case SpvOpVectorInsertDynamic:
        return component(one);
      case SpvOpImageFetch:
        return fetch(one);
      default:
        break;
    }
    if (one.op >= SpvOpAtomicLoad && one.op <= SpvOpAtomicXor) return atomic(one);
    module_.body.push_back(std::move(one));
  }

  void chain(Instruction& one) {
    Chain flat{one.operands[0], Words(one.operands.begin() + 1, one.operands.end())};
    if (const auto outer = chains_.find(flat.base); outer != chains_.end()) {
      flat.indices.insert(flat.indices.begin(), outer->second.indices.begin(), outer->second.indices.end());
      flat.base = outer->second.base;
    }
    chains_[one.result] = flat;
    one.op = SpvOpAccessChain;
    if (!uses_.contains(one.result)) return;  // only a step to others
    if (!guard(one, flat)) {
      one.operands = flat.indices;
      one.operands.insert(one.operands.begin(), flat.base);
      module_.body.push_back(std::move(one));
    }
  }

  /// The chain with indices that lead inside; false where all are constants.
  bool guard(const Instruction& one, const Chain& flat) {
    Id type = typeMaking(module_.typeOf(flat.base)).operands[1];
    Words held = flat.indices;
    Id inside = 0, length = 0, runtime = 0;
    std::size_t runtimeAt = 0, dynamic = 0;
    for (std::size_t i = 0; i < flat.indices.size(); ++i) {
      const Instruction made = typeMaking(type);
      const auto constant = module_.constant(flat.indices[i]);
      if (made.op == SpvOpTypeStruct) {
        type = made.operands[constant.value_or(0)];
        continue;
      }
      if (made.op == SpvOpTypeRuntimeArray) {
        const Id whole =
            emit(SpvOpArrayLength, module_.uintType(), {flat.base, *module_.constant(flat.indices[i - 1])});
        length = emit(SpvOpISub, module_.uintType(), {whole, module_.uintConstant(guardElements)});
        runtime = asUint(flat.indices[i]);
        runtimeAt = i;
        ++dynamic;
      } else if (!constant) {
        std::uint32_t count =
            made.op == SpvOpTypeArray ? module_.constant(made.operands[1]).value_or(1) : made.operands[1];
        if (const auto enlarged = shared_.find(flat.base); enlarged != shared_.end() && i == 0)
          count = enlarged->second;
        const Id index = asUint(flat.indices[i]);
        inside =
            both(inside, emit(SpvOpULessThan, module_.boolType(), {index, module_.uintConstant(count)}));
        held[i] = least(index, module_.uintConstant(count - 1));
        ++dynamic;
      }
      type = made.operands[0];
    }
    if (dynamic == 0) return false;
    const Use use = uses_[one.result];
    Guarded made{inside, inside, 0, false};
    const auto append = [&](Id result, const Words& indices) {
      Words operands = {flat.base};
      operands.insert(operands.end(), indices.begin(), indices.end());
      module_.noteType(result, one.type);
      module_.body.push_back({SpvOpAccessChain, one.type, result, std::move(operands)});
      return result;
    };
    if (runtime != 0) {
      const Id among = emit(SpvOpULessThan, module_.boolType(), {runtime, length});
      const Id all = both(inside, among);
      made = {0, all, 0, true};
      if (use.writes) {
        Words writes = held;
        const Id last = emit(SpvOpIAdd, module_.uintType(), {length, module_.uintConstant(1)});
        writes[runtimeAt] = select(all, module_.uintType(), runtime, last);
        made.write = append(module_.fresh(), writes);
      }
      held[runtimeAt] =
          inside == 0 ? least(runtime, length) : select(all, module_.uintType(), runtime, length);
    } else if (use.writes && shared_.contains(flat.base) && !module_.constant(flat.indices[0])) {
      Words writes = held;
      writes[0] = select(inside, module_.uintType(), held[0], module_.uintConstant(shared_[flat.base]));
      made.write = append(module_.fresh(), writes);
      made.drops = true;
    }
    if (use.reads || made.write == 0) append(one.result, held);
    if (made.write == 0) made.write = one.result;
    guarded_[one.result] = made;
    return true;
  }

  const Guarded* guardedBy(Id pointer) const {
    const auto found = guarded_.find(pointer);
    return found == guarded_.end() ? nullptr : &found->second;
  }

  void load(Instruction& one) {
    const Guarded* found = guardedBy(one.operands[0]);
    if (found == nullptr || found->inside == 0 || !selectable(one.type)) {
      module_.body.push_back(std::move(one));
      return;
    }
    const Id loaded = emit(SpvOpLoad, one.type, one.operands);
    select(found->inside, one.type, loaded, zero(one.type), one.result);
  }

  void store(Instruction& one) {
    if (const Guarded* found = guardedBy(one.operands[0])) {
      const Id type = module_.typeOf(one.operands[1]);
      if (!found->drops && found->inside != 0 && selectable(type)) {
        const Id old = emit(SpvOpLoad, type, {found->write});
        one.operands[1] = select(found->inside, type, one.operands[1], old);
      }
      one.operands[0] = found->write;
    }
    module_.body.push_back(std::move(one));
  }

  void atomic(Instruction& one) {
    const Guarded* found = guardedBy(one.operands[0]);
    if (found == nullptr) {
      module_.body.push_back(std::move(one));
      return;
    }
    one.operands[0] = found->write;
    if (one.result == 0) {
      module_.body.push_back(std::move(one));
      return;
    }
    const Id given = emit(one.op, one.type, one.operands);
    select(found->condition, one.type, given, zero(one.type), one.result);
  }

  void component(Instruction& one) {
    const bool insert = one.op == SpvOpVectorInsertDynamic;
    const std::size_t at = insert ? 2 : 1;
    const std::uint32_t count = typeMaking(module_.typeOf(one.operands[0])).operands[1];
    if (module_.constant(one.operands[at])) {
      module_.body.push_back(std::move(one));
      return;
    }
    const Id index = asUint(one.operands[at]), vector = one.operands[0];
    const Id inside = emit(SpvOpULessThan, module_.boolType(), {index, module_.uintConstant(count)});
    one.operands[at] = least(index, module_.uintConstant(count - 1));
    const Id made = emit(one.op, one.type, one.operands);
    select(inside, one.type, made, insert ? vector : zero(one.type), one.result);
  }

  /// A texel beyond the picture is zero; OpenGL says so of images only.
  void fetch(Instruction& one) {
    const Id image = one.operands[0], at = one.operands[1];
    const Instruction type = typeMaking(module_.typeOf(image));
    const bool hasLod = one.operands.size() > 3 && (one.operands[2] & SpvImageOperandsLodMask) != 0;
    if (type.operands[4] == 1 || (type.operands[1] != SpvDimBuffer && !hasLod)) {
      module_.body.push_back(std::move(one));
      return;
    }
    const Instruction shape = typeMaking(module_.typeOf(at));
    const std::uint32_t length = shape.op == SpvOpTypeVector ? shape.operands[1] : 1;
    const Id whole = module_.globalOf(SpvOpTypeInt, 0, {32, 1}), sizes = module_.vectorType(whole, length);
    const Id places = module_.vectorType(module_.uintType(), length),
             flags = module_.vectorType(module_.boolType(), length);
    const Id size = hasLod ? emit(SpvOpImageQuerySizeLod, sizes, {image, one.operands[3]})
                           : emit(SpvOpImageQuerySize, sizes, {image});
    const Id place = module_.typeOf(at) == places ? at : emit(SpvOpBitcast, places, {at});
    const Id below = emit(SpvOpULessThan, flags, {place, emit(SpvOpBitcast, places, {size})});
    const Id inside = length == 1 ? below : emit(SpvOpAll, module_.boolType(), {below});
    one.operands[1] = select(inside, module_.typeOf(at), at, zero(module_.typeOf(at)));
    const Id texel = emit(SpvOpImageFetch, one.type, one.operands);
    select(inside, one.type, texel, zero(one.type), one.result);
    queries_ = true;
  }

  Module& module_;
  Id set_;
  bool queries_ = false;
  struct Use {
    bool reads = false, writes = false;
  };

  std::unordered_map<Id, Use> uses_;
  std::unordered_map<Id, Chain> chains_;
  std::unordered_map<Id, Guarded> guarded_;
  std::unordered_map<Id, std::uint32_t> shared_;  ///< lengths before they were enlarged
  std::vector<std::pair<Id, Id>> retyped_;
};

}  // namespace

void keepInside(Module& module) {
  Bounds(module).run();
}

}  // namespace simreel::kernels

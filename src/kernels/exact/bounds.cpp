#include "kernels/exact/bounds.hpp"

#include "kernels/exact/room.hpp"
#include "kernels/exact/texels.hpp"
#include "kernels/spirv/facts.hpp"
#include "kernels/spirv/resource.hpp"
#include "kernels/spirv/writing.hpp"

#include <GLSL.std.450.h>
#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace simreel::kernels {

namespace {

/// A flattened access chain: a variable and the indices of all nested chains.
struct Chain {
  Id base = 0;
  Words indices;
};
/// Replacement of an access chain whose indices may be out of bounds. The new pointer for reads takes over
/// the result id of the original chain.
struct Guarded {
  Id inside = 0;  ///< id of a bool that is true if all indices are in bounds; 0 if out-of-bounds reads are
                  ///< redirected to a guard element
  Id condition = 0;    ///< id of the same bool, for results of atomic operations
  Id write = 0;        ///< id of the pointer for writes and atomic operations
  bool drops = false;  ///< true if out-of-bounds accesses through `write` are redirected to a guard element
};

class Bounds {
 public:
  Bounds(Module& module, Report* report)
      : module_(module), set_(module.extendedSet()), report_(report), facts_(module) {}

  void run() {
    shared_ = enlargeShared(module_);
    std::vector<Instruction> body = std::move(module_.body);
    module_.body.clear();
    for (const Instruction& one : body) noteUse(one);
    for (Instruction& one : body) {
      if (report_ != nullptr) {
        at_.follow(module_, report_->files(), one);
        excused_ = report_->excuse(one.result);
      }
      if (one.op == SpvOpFunction) inLibrary_ = (one.operands[0] & SpvFunctionControlDontInlineMask) != 0;
      if (one.op == SpvOpLabel) block_ = one.result;
      if (inLibrary_) {
        module_.body.push_back(std::move(one));
      } else {
        place(one);
      }
    }
    module_.index();
  }

 private:
  /// Already emitted comparison of an index with a length. `inside` is the id of its result.
  struct EmittedComparison {
    Id block, inside, length;
  };
  struct Use {
    bool reads = false, writes = false;
  };
  /// An index of an access chain that is compared with a length. `at`: position of the index in the chain.
  struct CheckedIndex {
    std::size_t at;
    Id inside, index;
  };
  /// The checked indices of an access chain.
  struct CheckedIndices {
    Words held;                         ///< indices clamped to their bounds, except the index of a buffer's
                                        ///< element
    std::vector<CheckedIndex> checked;  ///< indices that may be out of bounds
    Id inside;  ///< id of a bool that is true if the clamped indices were in bounds; 0
                ///< if no index is clamped
    Id length, runtime,
        among;  ///< for a buffer: the ids of the buffer's length, of the element index, and of the bool
                ///< "index < length"
    std::size_t runtimeAt;
  };

  Id emit(SpvOp op, Id type, Words operands) {
    const Id made = module_.fresh();
    module_.noteType(made, type);
    module_.body.push_back({op, type, made, std::move(operands)});
    return made;
  }
  Id minimum(Id a, Id b) { return emit(SpvOpExtInst, module_.uintType(), {set_, GLSLstd450UMin, a, b}); }
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
  Id select(Id condition, Id type, Id a, Id b, Id result = 0) {
    return Writing(module_, module_.body).select(condition, type, a, b, result);
  }

  /// Records which pointers an instruction reads and writes. Access chains are not counted as reads of
  /// their base.
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
    if (!uses_.contains(one.result))
      return;  // The pointer is used only as the base of other chains, so it
               // needs no guard.
    if (!guard(one, flat)) {
      one.operands = flat.indices;
      one.operands.insert(one.operands.begin(), flat.base);
      module_.body.push_back(std::move(one));
    }
  }

  /// Returns the length of the array, vector or matrix that index `i` of a chain selects from.
  std::uint32_t countOf(const Chain& flat, std::size_t i, const Instruction& type) const {
    if (const auto enlarged = shared_.find(flat.base); enlarged != shared_.end() && i == 0)
      return enlarged->second;
    return type.op == SpvOpTypeArray ? module_.constant(type.operands[1]).value_or(1) : type.operands[1];
  }

  /// True unless the index is provably less than `count`. A constant index may also be too large, because
  /// the optimizer can create such constants.
  bool mayExceed(Id index, std::uint32_t count) const {
    const auto constant = module_.constant(index);
    return constant ? *constant >= count : facts_.atMost(index, block_) >= count;
  }

  /// Returns the comparison of an index with a length. `key` identifies the operands. Reuses a comparison
  /// from a block that dominates the current block. If there is none, emits the comparison in the current
  /// block.
  template <class Emit>
  const EmittedComparison& comparison(const Words& key, Emit emitted) {
    std::vector<EmittedComparison>& all = known_[key];
    const auto found = std::find_if(all.begin(), all.end(), [&](const EmittedComparison& one) {
      return facts_.dominates(one.block, block_);
    });
    if (found != all.end()) return *found;
    all.push_back(emitted());
    return all.back();
  }
  const EmittedComparison& amongElements(const Chain& flat, std::size_t i, Id index) {
    const std::uint32_t member = *module_.constant(flat.indices[i - 1]);
    return comparison({flat.base, member, flat.indices[i]}, [&] {
      const Id whole = emit(SpvOpArrayLength, module_.uintType(), {flat.base, member});
      const Id length = emit(SpvOpISub, module_.uintType(), {whole, module_.uintConstant(guardElements)});
      return EmittedComparison{block_, emit(SpvOpULessThan, module_.boolType(), {index, length}), length};
    });
  }
  Id belowCount(Id value, Id index, std::uint32_t count) {
    return comparison({value, count},
                      [&] {
                        return EmittedComparison{
                            block_,
                            emit(SpvOpULessThan, module_.boolType(), {index, module_.uintConstant(count)}),
                            0};
                      })
        .inside;
  }

  /// Emits comparisons with the lengths for those indices of a chain that may be out of bounds.
  CheckedIndices walk(const Chain& flat) {
    CheckedIndices found{flat.indices, {}, 0, 0, 0, 0, 0};
    Id type = typeMaking(module_.typeOf(flat.base)).operands[1];
    for (std::size_t i = 0; i < flat.indices.size(); ++i) {
      const Instruction made = typeMaking(type);
      const auto constant = module_.constant(flat.indices[i]);
      if (made.op == SpvOpTypeStruct) {
        type = made.operands[constant.value_or(0)];
        continue;
      }
      if (made.op == SpvOpTypeRuntimeArray) {
        found.runtime = asUint(flat.indices[i]);
        found.runtimeAt = i;
        const EmittedComparison& known = amongElements(flat, i, found.runtime);
        found.length = known.length;
        found.among = known.inside;
        found.checked.push_back({i, found.among, found.runtime});
      } else if (const std::uint32_t count = countOf(flat, i, made); mayExceed(flat.indices[i], count)) {
        const Id index = asUint(flat.indices[i]);
        const Id below = belowCount(flat.indices[i], index, count);
        found.inside = both(found.inside, below);
        found.held[i] = minimum(index, module_.uintConstant(count - 1));
        found.checked.push_back({i, below, index});
      }
      type = made.operands[0];
    }
    return found;
  }

  Id append(const Instruction& one, Id result, Id base, const Words& indices) {
    Words operands = {base};
    operands.insert(operands.end(), indices.begin(), indices.end());
    module_.noteType(result, one.type);
    module_.body.push_back({SpvOpAccessChain, one.type, result, std::move(operands)});
    return result;
  }

  /// Replaces a chain by one whose indices are in bounds. Returns false if all indices are constants.
  bool guard(const Instruction& one, const Chain& flat) {
    if (module_.name(flat.base).starts_with("simreel_"))
      return false;  // Another guard has inserted this variable.
    CheckedIndices found = walk(flat);
    if (found.checked.empty()) return false;
    const Use use = uses_[one.result];
    for (const CheckedIndex& index : found.checked) note(index, flat, use);
    const Id inside = found.inside, number = module_.uintType();
    Guarded made{inside, inside, 0, false};
    if (found.runtime != 0) {
      const Id all = both(inside, found.among);
      made = {0, all, 0, true};
      if (use.writes) {
        Words writes = found.held;
        const Id last = emit(SpvOpIAdd, number, {found.length, module_.uintConstant(1)});
        writes[found.runtimeAt] = select(all, number, found.runtime, last);
        made.write = append(one, module_.fresh(), flat.base, writes);
      }
      found.held[found.runtimeAt] = inside == 0 ? minimum(found.runtime, found.length)
                                                : select(all, number, found.runtime, found.length);
    } else if (use.writes && shared_.contains(flat.base) &&
               mayExceed(flat.indices[0], shared_[flat.base])) {
      Words writes = found.held;
      writes[0] = select(inside, number, found.held[0], module_.uintConstant(shared_[flat.base]));
      made.write = append(one, module_.fresh(), flat.base, writes);
      made.drops = true;
    }
    if (use.reads || made.write == 0) append(one, one.result, flat.base, found.held);
    if (made.write == 0) made.write = one.result;
    guarded_[one.result] = made;
    return true;
  }

  /// Emits the report of an out-of-bounds index if the access is in the user's code.
  void note(const CheckedIndex& index, const Chain& flat, const Use& use) {
    if (report_ == nullptr || at_.line == 0) return;
    const std::string name = indexedName(module_, flat.base, std::span(flat.indices).first(index.at + 1));
    note(index.inside, use.writes ? "write" : "read", name, index.index);
  }
  void note(Id inside, const char* kind, const std::string& name, Id index) {
    // An invocation stores only its first fault, so a second test of the same condition would have no
    // effect.
    if (report_ != nullptr && at_.line != 0 && !noted_.contains(inside)) {
      if (!excused_) noted_.insert(inside);
      report_->note(module_, module_.body, inside, report_->place(kind, name, at_), index, index);
    }
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
    if (!mayExceed(one.operands[at], count)) {
      module_.body.push_back(std::move(one));
      return;
    }
    const Id index = asUint(one.operands[at]), vector = one.operands[0];
    const Id inside = emit(SpvOpULessThan, module_.boolType(), {index, module_.uintConstant(count)});
    note(inside, insert ? "write" : "read", "a vector", index);
    one.operands[at] = minimum(index, module_.uintConstant(count - 1));
    const Id made = emit(one.op, one.type, one.operands);
    select(inside, one.type, made, insert ? vector : zero(one.type), one.result);
  }

  Module& module_;
  Id set_;
  Report* report_;
  Facts facts_;
  Position at_;
  Id block_ = 0;            ///< label of the current block
  bool inLibrary_ = false;  ///< true in a library function, whose indices are always in bounds

  std::map<Words, std::vector<EmittedComparison>>
      known_;                     ///< emitted comparisons by the ids of their operands
  std::unordered_set<Id> noted_;  ///< ids of conditions that reports have tested
  bool excused_ = false;          ///< true for a value that is used only under a condition
                                  ///< (excuses.hpp)
  std::unordered_map<Id, Use> uses_;
  std::unordered_map<Id, Chain> chains_;
  std::unordered_map<Id, Guarded> guarded_;
  std::unordered_map<Id, std::uint32_t> shared_;  ///< array lengths before enlargeShared(), by variable
};

}  // namespace

void keepInside(Module& module, Report* report) {
  if (report != nullptr) report->findExcuses(module);
  Bounds(module, report).run();
  keepTexelsInside(module, report);
  if (report != nullptr) report->excuse(0);
}

}  // namespace simreel::kernels

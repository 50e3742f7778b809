#include "kernels/guards/race.hpp"

#include "kernels/guards/words.hpp"
#include "kernels/spirv/resource.hpp"
#include "kernels/spirv/writing.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace simreel::kernels {

namespace {

class Races {
 public:
  Races(Module& module, bool hlsl, std::uint32_t guards, Report* report)
      : module_(module), writing_(module, module.body), hlsl_(hlsl), guards_(guards), report_(report) {}

  void run() {
    findShadowed();
    if (shadows_.empty()) return;
    std::vector<Instruction> body = std::move(module_.body);
    module_.body.clear();
    for (Instruction& one : body) {
      if (report_ != nullptr) at_.follow(module_, report_->files(), one);
      chains_.follow(one);
      place(one);
      module_.body.push_back(std::move(one));
    }
    for (const auto& [key, function] : functions_) write(key.first, key.second, function);
    if (queries_)
      module_.head.insert(module_.head.begin(), {SpvOpCapability, 0, 0, {SpvCapabilityImageQuery}});
    module_.index();
  }

 private:
  enum class Task { record, read, store };

  /// Creates a shadow buffer for each variable that the kernel stores to, unless the checks do not support
  /// it (cube maps, multisampled images and arrays of resources) or the program itself has added it (names
  /// that begin with simreel_).
  void findShadowed() {
    std::vector<Id> stored;
    const auto add = [&](Id variable) {
      if (std::find(stored.begin(), stored.end(), variable) == stored.end()) stored.push_back(variable);
    };
    for (const Instruction& one : module_.body) {
      chains_.follow(one);
      if (one.op == SpvOpLoad && module_.global(one.type)->op == SpvOpTypeImage)
        images_[one.result] = one.operands[0];
      if (one.op == SpvOpStore) add(chains_.of(one.operands[0]).variable);
      if (one.op == SpvOpImageWrite && sized(one.operands[0])) add(images_[one.operands[0]]);
      if (one.op == SpvOpImageRead) readImages_.insert(images_[one.operands[0]]);
    }
    for (const Id variable : stored) {
      const Instruction* made = module_.global(variable);
      if (made == nullptr) continue;
      const Resource kind = resourceOf(module_, *made);
      const std::string name = kind == Resource::image ? plainName(module_.name(variable))
                                                       : bufferName(module_, variable, hlsl_);
      if ((kind != Resource::storage && kind != Resource::image) || name.starts_with("simreel_") ||
          isArrayed(module_, *made))
        continue;
      shadows_[variable] = storageBuffer(module_, name + shadowSuffix, "words", module_.uintType(), 4);
      giveName(module_, shadows_[variable], name + shadowSuffix);
    }
  }

  /// Returns true for images with one linear index per texel. Excludes cube maps and multisampled images.
  bool sized(Id image) const {
    const Instruction& type = *module_.global(module_.typeOf(image));
    return type.operands[4] == 0 && type.operands[1] != SpvDimCube && images_.contains(image);
  }

  void place(const Instruction& one) {
    switch (one.op) {
      case SpvOpLoad:
        if (report_ != nullptr && !images_.contains(one.result)) check(one.operands[0], Task::read);
        return;
      case SpvOpStore:
        return report_ != nullptr ? check(one.operands[0], Task::store)
                                  : record(one.operands[0], one.operands[1]);
      case SpvOpImageRead:
        if (report_ != nullptr) texel(one, Task::read);
        return;
      case SpvOpImageWrite:
        return texel(one, report_ != nullptr ? Task::store : Task::record);
      default:
        return;
    }
  }

  /// Emits a bool that is true if an access goes to a real element of a buffer, and false for a guard
  /// element.
  Id active(const WordsIn::Access& access, Id variable) {
    if (guards_ == 0 || access.array == 0 || module_.global(access.array)->op != SpvOpTypeRuntimeArray)
      return module_.globalOf(SpvOpConstantTrue, module_.boolType(), {});
    const Id number = module_.uintType();
    const Id whole = writing_.emit(SpvOpArrayLength, number, {variable, access.member});
    const Id length = writing_.emit(SpvOpISub, number, {whole, module_.uintConstant(guards_)});
    return writing_.emit(SpvOpULessThan, module_.boolType(), {writing_.asUint(access.element), length});
  }

  Id word(Id first, std::uint32_t offset) {
    return offset == 0
               ? first
               : writing_.emit(SpvOpIAdd, module_.uintType(), {first, module_.uintConstant(offset)});
  }

  void call(Id variable, Task task, const Words& arguments) {
    Id& function = functions_[{variable, task}];
    if (function == 0) function = module_.fresh();
    Words operands = {function};
    operands.insert(operands.end(), arguments.begin(), arguments.end());
    writing_.emit(SpvOpFunctionCall, module_.globalOf(SpvOpTypeVoid, 0, {}), operands);
  }

  void record(Id pointer, Id value) {
    const PointerChain chain = chains_.of(pointer);
    if (!shadows_.contains(chain.variable)) return;
    WordsIn words(module_, false);
    const WordsIn::Access access = words.access(writing_, chain);
    const Id inside = active(access, chain.variable);
    Words before, after;
    const Id block = resourceType(module_, *module_.global(chain.variable)).result;
    const bool writeOnly =
        module_.decoration(chain.variable, SpvDecorationNonReadable).has_value() ||
        module_.memberDecoration(block, access.member, SpvDecorationNonReadable).has_value();
    words.parts(writing_, value, access.type, after);
    if (!writeOnly) words.parts(writing_, writing_.load(access.type, pointer), access.type, before);
    const std::vector<std::uint32_t> offsets = words.offsets(access);
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      const Id changed = writeOnly
                             ? module_.globalOf(SpvOpConstantTrue, module_.boolType(), {})
                             : writing_.emit(SpvOpINotEqual, module_.boolType(), {before[i], after[i]});
      call(chain.variable, Task::record, {inside, word(access.first, offsets[i]), after[i], changed});
    }
  }

  void check(Id pointer, Task task) {
    const PointerChain chain = chains_.of(pointer);
    if (!shadows_.contains(chain.variable)) return;
    WordsIn words(module_, false);
    const WordsIn::Access access = words.access(writing_, chain);
    const Id inside = active(access, chain.variable);
    const Id number = module_.uintConstant(report_->place(kindOf(task), access.what, at_, access.part));
    for (const std::uint32_t offset : words.offsets(access))
      call(chain.variable, task, {inside, word(access.first, offset), number, access.element});
  }

  static const char* kindOf(Task task) { return task == Task::read ? "race-read" : "race-write"; }

  void texel(const Instruction& one, Task task) {
    const Id image = one.operands[0], variable = images_[image];
    if (!shadows_.contains(variable)) return;
    const auto [inside, at] = texelNumber(image, one.operands[1]);
    if (task != Task::record) {
      const Id number =
          module_.uintConstant(report_->place(kindOf(task), plainName(module_.name(variable)), at_));
      return call(variable, task, {inside, at, number, writing_.asInt(at)});
    }
    const Id after = mixed(one.operands[2], image);
    Id changed = module_.globalOf(SpvOpConstantTrue, module_.boolType(), {});
    if (readImages_.contains(variable)) {
      const Id type = module_.typeOf(one.operands[2]);
      const Id old = writing_.emit(SpvOpImageRead, type, {image, one.operands[1]});
      changed = writing_.emit(SpvOpINotEqual, module_.boolType(), {mixed(old, image), after});
    }
    call(variable, task, {inside, at, after, changed});
  }

  /// Emits the test whether a texel is inside its image, and the texel's linear index (x fastest, then y,
  /// then z).
  std::pair<Id, Id> texelNumber(Id image, Id at) {
    const Instruction shape = *module_.global(module_.typeOf(at));
    const std::uint32_t length = shape.op == SpvOpTypeVector ? shape.operands[1] : 1;
    const Id number = module_.uintType(), flag = module_.boolType();
    const Id numbers = module_.vectorType(number, length), flags = module_.vectorType(flag, length);
    const Id size =
        writing_.emit(SpvOpImageQuerySize, module_.vectorType(module_.intType(), length), {image});
    const Id sizes = writing_.emit(SpvOpBitcast, numbers, {size});
    const Id place = module_.typeOf(at) == numbers ? at : writing_.emit(SpvOpBitcast, numbers, {at});
    const Id below = writing_.emit(SpvOpULessThan, flags, {place, sizes});
    queries_ = true;
    if (length == 1) return {below, place};
    Id sum = writing_.emit(SpvOpCompositeExtract, number, {place, length - 1});
    for (std::uint32_t i = length - 1; i-- > 0;) {
      const Id width = writing_.emit(SpvOpCompositeExtract, number, {sizes, i});
      const Id before = writing_.emit(SpvOpIMul, number, {sum, width});
      sum = writing_.emit(SpvOpIAdd, number,
                          {before, writing_.emit(SpvOpCompositeExtract, number, {place, i})});
    }
    return {writing_.emit(SpvOpAll, flag, {below}), sum};
  }

  /// Emits a hash of the components of a texel that the image format stores.
  Id mixed(Id value, Id image) {
    Words words;
    WordsIn(module_, true).parts(writing_, value, module_.typeOf(value), words);
    words.resize(std::min<std::size_t>(words.size(), components(image)));
    Id sum = words[0];
    for (std::size_t i = 1; i < words.size(); ++i) {
      const Id product =
          writing_.emit(SpvOpIMul, module_.uintType(), {sum, module_.uintConstant(0x9E3779B1U)});
      sum = writing_.emit(SpvOpBitwiseXor, module_.uintType(), {product, words[i]});
    }
    return sum;
  }

  std::size_t components(Id image) const {
    switch (module_.global(module_.typeOf(image))->operands[6]) {
      case SpvImageFormatR32f:
      case SpvImageFormatR16f:
      case SpvImageFormatR16:
      case SpvImageFormatR8:
      case SpvImageFormatR16Snorm:
      case SpvImageFormatR8Snorm:
      case SpvImageFormatR32i:
      case SpvImageFormatR16i:
      case SpvImageFormatR8i:
      case SpvImageFormatR32ui:
      case SpvImageFormatR16ui:
      case SpvImageFormatR8ui:
        return 1;
      case SpvImageFormatRg32f:
      case SpvImageFormatRg16f:
      case SpvImageFormatRg16:
      case SpvImageFormatRg8:
      case SpvImageFormatRg16Snorm:
      case SpvImageFormatRg8Snorm:
      case SpvImageFormatRg32i:
      case SpvImageFormatRg16i:
      case SpvImageFormatRg8i:
      case SpvImageFormatRg32ui:
      case SpvImageFormatRg16ui:
      case SpvImageFormatRg8ui:
        return 2;
      case SpvImageFormatR11fG11fB10f:
        return 3;
      default:
        return 4;
    }
  }

  Id shadowWord(Id variable, Id word, std::uint32_t at) {
    const Id number = module_.uintType();
    Id index = writing_.emit(SpvOpIMul, number, {word, module_.uintConstant(shadowWords)});
    if (at != 0) index = writing_.emit(SpvOpIAdd, number, {index, module_.uintConstant(at)});
    return writing_.chain(SpvStorageClassStorageBuffer, number, shadows_[variable],
                          {module_.uintConstant(0), index});
  }

  /// Emits the function for a task: record(active, word, value, changed) or check(active, word, place,
  /// element).
  void write(Id variable, Task task, Id function) {
    const Id number = module_.uintType(), flag = module_.boolType(), one = module_.uintConstant(1);
    const Id last = task == Task::record ? flag : module_.intType();
    const Words given = writing_.function(function, {flag, number, number, last});
    const char* names[] = {"simreel_record", "simreel_check_read", "simreel_check_store"};
    giveName(module_, function, names[static_cast<int>(task)]);
    const Id linear = linearInvocation(module_, module_.body);
    const Id self = writing_.emit(SpvOpIAdd, number, {linear, one});
    if (task == Task::record) {
      const Id merge = writing_.open(given[0]);
      raise(variable, given[1], 1, writing_.emit(SpvOpNot, number, {given[2]}));
      raise(variable, given[1], 2, given[2]);
      const Id zero = module_.uintConstant(0);
      raise(variable, given[1], 0, writing_.select(given[3], number, self, zero));
      writing_.close(merge);
      return writing_.end();
    }
    const Id other = writing_.load(number, shadowWord(variable, given[1], 0));
    Id fine = writing_.emit(SpvOpLogicalNot, flag, {given[0]});
    const auto orElse = [&](Id condition) {
      fine = writing_.emit(SpvOpLogicalOr, flag, {fine, condition});
    };
    orElse(writing_.emit(SpvOpIEqual, flag, {other, module_.uintConstant(0)}));
    orElse(writing_.emit(SpvOpIEqual, flag, {other, self}));
    if (task == Task::store) {
      const Id minimum = writing_.load(number, shadowWord(variable, given[1], 1));
      const Id maximum = writing_.load(number, shadowWord(variable, given[1], 2));
      orElse(writing_.emit(SpvOpIEqual, flag, {writing_.emit(SpvOpNot, number, {minimum}), maximum}));
    }
    const Id writer = writing_.emit(SpvOpISub, number, {other, one});
    report_->noteAt(module_, module_.body, fine, given[2], writer, given[3]);
    writing_.end();
  }

  void raise(Id variable, Id word, std::uint32_t at, Id value) {
    writing_.emit(SpvOpAtomicUMax, module_.uintType(),
                  {shadowWord(variable, word, at), module_.uintConstant(SpvScopeDevice),
                   module_.uintConstant(0), value});
  }

  Module& module_;
  Writing writing_;
  bool hlsl_;
  std::uint32_t guards_;
  Report* report_;  ///< report for the check variant; nullptr in the record variant
  Position at_;
  Chains chains_;
  std::map<Id, Id> shadows_;  ///< shadow buffers by variable
  std::map<std::pair<Id, Task>, Id> functions_;
  std::unordered_map<Id, Id> images_;  ///< variables from which images were loaded, by the image's id
  std::unordered_set<Id> readImages_;
  bool queries_ = false;
};

}  // namespace

void recordWrites(Module& module, bool hlsl, std::uint32_t guards) {
  Races(module, hlsl, guards, nullptr).run();
}

void checkAccesses(Module& module, bool hlsl, std::uint32_t guards, Report& report) {
  Races(module, hlsl, guards, &report).run();
}

}  // namespace simreel::kernels

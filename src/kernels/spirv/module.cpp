#include "kernels/spirv/module.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

constexpr std::uint32_t magic = 0x07230203;

Instruction decode(std::span<const std::uint32_t> words) {
  Instruction made;
  made.op = static_cast<SpvOp>(words[0] & 0xffffU);
  bool hasResult = false, hasType = false;
  SpvHasResultAndType(made.op, &hasResult, &hasType);
  std::size_t at = 1;
  const auto nextWord = [&] {
    if (at >= words.size()) throw std::runtime_error("an instruction of SPIR-V is too short");
    return words[at++];
  };
  if (hasType) made.type = nextWord();
  if (hasResult) made.result = nextWord();
  made.operands.assign(words.begin() + static_cast<std::ptrdiff_t>(at), words.end());
  return made;
}

void encode(const Instruction& instruction, Words& out) {
  const std::size_t count =
      1 + (instruction.type != 0 ? 1 : 0) + (instruction.result != 0 ? 1 : 0) + instruction.operands.size();
  out.push_back(static_cast<std::uint32_t>(count << 16U) | static_cast<std::uint32_t>(instruction.op));
  if (instruction.type != 0) out.push_back(instruction.type);
  if (instruction.result != 0) out.push_back(instruction.result);
  out.insert(out.end(), instruction.operands.begin(), instruction.operands.end());
}

bool endsBlock(SpvOp op) {
  return op == SpvOpBranch || op == SpvOpBranchConditional || op == SpvOpSwitch || op == SpvOpReturn ||
         op == SpvOpReturnValue || op == SpvOpKill || op == SpvOpUnreachable;
}

bool isHead(SpvOp op) {
  switch (op) {
    case SpvOpCapability:
    case SpvOpExtension:
    case SpvOpExtInstImport:
    case SpvOpMemoryModel:
    case SpvOpEntryPoint:
    case SpvOpExecutionMode:
    case SpvOpString:
    case SpvOpSource:
    case SpvOpSourceExtension:
    case SpvOpSourceContinued:
    case SpvOpName:
    case SpvOpMemberName:
    case SpvOpModuleProcessed:
      return true;
    default:
      return false;
  }
}

bool isDecoration(SpvOp op) {
  return op == SpvOpDecorate || op == SpvOpMemberDecorate || op == SpvOpDecorateId ||
         op == SpvOpDecorateString || op == SpvOpMemberDecorateString;
}

bool isShared(SpvOp op) {
  switch (op) {
    case SpvOpTypeVoid:
    case SpvOpTypeBool:
    case SpvOpTypeInt:
    case SpvOpTypeFloat:
    case SpvOpTypeVector:
    case SpvOpTypeMatrix:
    case SpvOpTypePointer:
    case SpvOpTypeFunction:
    case SpvOpTypeImage:
    case SpvOpTypeSampler:
    case SpvOpTypeSampledImage:
    case SpvOpConstant:
    case SpvOpConstantTrue:
    case SpvOpConstantFalse:
    case SpvOpConstantComposite:
    case SpvOpConstantNull:
      return true;
    default:
      return false;
  }
}

std::pair<std::uint32_t, Words> key(SpvOp op, Id type, const Words& operands) {
  Words all = {type};
  all.insert(all.end(), operands.begin(), operands.end());
  return {static_cast<std::uint32_t>(op), std::move(all)};
}

}  // namespace

Module::Module(std::span<const std::uint32_t> words) {
  if (words.size() < 5 || words[0] != magic) throw std::runtime_error("no SPIR-V");
  version_ = words[1];
  generator_ = words[2];
  bound_ = words[3];
  bool inBody = false, ended = false;
  for (std::size_t at = 5; at < words.size();) {
    const std::size_t count = words[at] >> 16U;
    if (count == 0 || at + count > words.size())
      throw std::runtime_error("SPIR-V ends within an instruction");
    Instruction made = decode(words.subspan(at, count));
    at += count;
    inBody = inBody || made.op == SpvOpFunction;
    if (made.op == SpvOpLabel || made.op == SpvOpFunctionEnd) ended = false;
    if (ended) continue;  // Dead code that glslang 12 emits after some returns is skipped.
    ended = inBody && endsBlock(made.op);
    if (inBody)
      body.push_back(std::move(made));
    else if (isHead(made.op))
      head.push_back(std::move(made));
    else if (isDecoration(made.op))
      decorations.push_back(std::move(made));
    else if (made.op != SpvOpLine && made.op != SpvOpNoLine)
      globals.push_back(std::move(made));
  }
  index();
}

Words Module::words() const {
  Words out = {magic, version_, generator_, bound_, 0};
  // SPIR-V requires debug strings and names after the execution modes.
  const auto rank = [](SpvOp op) {
    switch (op) {
      case SpvOpCapability:
        return 0;
      case SpvOpExtension:
        return 1;
      case SpvOpExtInstImport:
        return 2;
      case SpvOpMemoryModel:
        return 3;
      case SpvOpEntryPoint:
        return 4;
      case SpvOpExecutionMode:
        return 5;
      case SpvOpName:
      case SpvOpMemberName:
        return 7;
      case SpvOpModuleProcessed:
        return 8;
      default:
        return 6;
    }
  };
  std::vector<const Instruction*> ordered;
  ordered.reserve(head.size());
  for (const Instruction& one : head) ordered.push_back(&one);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [&](const Instruction* a, const Instruction* b) { return rank(a->op) < rank(b->op); });
  for (const Instruction* one : ordered) encode(*one, out);
  for (const auto* section : {&decorations, &globals, &body})
    for (const Instruction& one : *section) encode(one, out);
  return out;
}

void Module::index() {
  definitions_.clear();
  types_.clear();
  known_.clear();
  for (std::size_t i = 0; i < globals.size(); ++i) {
    const Instruction& one = globals[i];
    if (one.result == 0) continue;
    definitions_[one.result] = i;
    if (one.type != 0) types_[one.result] = one.type;
    if (isShared(one.op)) known_.try_emplace(key(one.op, one.type, one.operands), one.result);
  }
  for (const Instruction& one : body)
    if (one.result != 0 && one.type != 0) types_[one.result] = one.type;
}

Id Module::typeOf(Id value) const {
  const auto found = types_.find(value);
  return found == types_.end() ? 0 : found->second;
}

const Instruction* Module::global(Id id) const {
  const auto found = definitions_.find(id);
  return found == definitions_.end() ? nullptr : &globals[found->second];
}

Id Module::addGlobal(SpvOp op, Id type, const Words& operands) {
  const Id made = fresh();
  globals.push_back({op, type, made, operands});
  definitions_[made] = globals.size() - 1;
  if (type != 0) types_[made] = type;
  if (isShared(op)) known_.try_emplace(key(op, type, operands), made);
  return made;
}

Id Module::globalOf(SpvOp op, Id type, const Words& operands) {
  const auto found = known_.find(key(op, type, operands));
  return found != known_.end() ? found->second : addGlobal(op, type, operands);
}

void Module::decorate(Id id, SpvDecoration what, const Words& values) {
  Words operands = {id, static_cast<std::uint32_t>(what)};
  operands.insert(operands.end(), values.begin(), values.end());
  decorations.push_back({SpvOpDecorate, 0, 0, std::move(operands)});
}

std::optional<std::uint32_t> Module::constant(Id id) const {
  const Instruction* made = global(id);
  if (made == nullptr || made->op != SpvOpConstant || made->operands.empty()) return std::nullopt;
  return made->operands[0];
}

Id Module::floatType() {
  return globalOf(SpvOpTypeFloat, 0, {32});
}
Id Module::uintType() {
  return globalOf(SpvOpTypeInt, 0, {32, 0});
}
Id Module::intType() {
  return globalOf(SpvOpTypeInt, 0, {32, 1});
}
Id Module::boolType() {
  return globalOf(SpvOpTypeBool, 0, {});
}
Id Module::vectorType(Id component, std::uint32_t length) {
  return length == 1 ? component : globalOf(SpvOpTypeVector, 0, {component, length});
}
Id Module::uintConstant(std::uint32_t value) {
  return globalOf(SpvOpConstant, uintType(), {value});
}

Id Module::extendedSet(bool make) {
  for (const Instruction& one : head)
    if (one.op == SpvOpExtInstImport && literalText(one.operands) == "GLSL.std.450") return one.result;
  if (!make) return 0;
  const Id made = fresh();
  head.push_back({SpvOpExtInstImport, 0, made, textWords("GLSL.std.450")});
  return made;
}

std::string Module::name(Id id) const {
  for (const Instruction& one : head)
    if (one.op == SpvOpName && one.operands[0] == id)
      return literalText(std::span(one.operands).subspan(1));
  return {};
}

std::string Module::memberName(Id type, std::uint32_t member) const {
  for (const Instruction& one : head)
    if (one.op == SpvOpMemberName && one.operands[0] == type && one.operands[1] == member)
      return literalText(std::span(one.operands).subspan(2));
  return {};
}

std::string Module::text(Id id) const {
  for (const Instruction& one : head)
    if (one.op == SpvOpString && one.result == id) return literalText(one.operands);
  return {};
}

std::optional<std::uint32_t> Module::decoration(Id id, SpvDecoration what) const {
  for (const Instruction& one : decorations)
    if (one.op == SpvOpDecorate && one.operands[0] == id &&
        one.operands[1] == static_cast<std::uint32_t>(what))
      return one.operands.size() > 2 ? one.operands[2] : 0;
  return std::nullopt;
}

std::optional<std::uint32_t> Module::memberDecoration(Id type, std::uint32_t member,
                                                      SpvDecoration what) const {
  for (const Instruction& one : decorations)
    if (one.op == SpvOpMemberDecorate && one.operands[0] == type && one.operands[1] == member &&
        one.operands[2] == static_cast<std::uint32_t>(what))
      return one.operands.size() > 3 ? one.operands[3] : 0;
  return std::nullopt;
}

std::string Module::signature(Id type) const {
  const Instruction* made = global(type);
  if (made == nullptr) return "?";
  switch (made->op) {
    case SpvOpTypeFloat:
      return made->operands[0] == 32 ? "f1" : "?";
    case SpvOpTypeInt:
      return made->operands[0] != 32 ? "?" : made->operands[1] == 1 ? "i1" : "u1";
    case SpvOpTypeBool:
      return "b1";
    case SpvOpTypeVector: {
      const std::string component = signature(made->operands[0]);
      return component == "?" ? "?" : fmt::format("v{}{}", component[0], made->operands[1]);
    }
    case SpvOpTypeMatrix: {
      const std::string column = signature(made->operands[0]);
      return column.size() != 3 ? "?" : fmt::format("m{}{}{}", column[1], made->operands[1], column[2]);
    }
    default:
      return "?";
  }
}

std::string literalText(std::span<const std::uint32_t> words) {
  std::string text;
  for (const std::uint32_t word : words)
    for (unsigned shift = 0; shift < 32; shift += 8) {
      const char c = static_cast<char>((word >> shift) & 0xffU);
      if (c == '\0') return text;
      text += c;
    }
  return text;
}

Words textWords(const std::string& text) {
  Words words(text.size() / 4 + 1, 0);
  for (std::size_t i = 0; i < text.size(); ++i)
    words[i / 4] |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])) << (8 * (i % 4));
  return words;
}

}  // namespace simreel::kernels

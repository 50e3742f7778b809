#include "kernels/guards/words.hpp"

#include "kernels/spirv/resource.hpp"

namespace simreel::kernels {

void Chains::follow(const Instruction& one) {
  if (one.op != SpvOpAccessChain && one.op != SpvOpInBoundsAccessChain) return;
  PointerChain flat = of(one.operands[0]);
  flat.indices.insert(flat.indices.end(), one.operands.begin() + 1, one.operands.end());
  chains_[one.result] = std::move(flat);
}

PointerChain Chains::of(Id pointer) const {
  const auto found = chains_.find(pointer);
  return found == chains_.end() ? PointerChain{pointer, {}} : found->second;
}

std::uint32_t WordsIn::stride(Id array) {
  return packed_ ? size(made(array).operands[0])
                 : module_.decoration(array, SpvDecorationArrayStride).value_or(4) / 4;
}

std::uint32_t WordsIn::offset(Id structure, std::uint32_t member) {
  if (!packed_) return module_.memberDecoration(structure, member, SpvDecorationOffset).value_or(0) / 4;
  std::uint32_t sum = 0;
  for (std::uint32_t i = 0; i < member; ++i) sum += size(made(structure).operands[i]);
  return sum;
}

WordsIn::Matrix WordsIn::matrix(Id structure, std::uint32_t member) const {
  if (packed_) return {};
  return {module_.memberDecoration(structure, member, SpvDecorationRowMajor).has_value(),
          module_.memberDecoration(structure, member, SpvDecorationMatrixStride).value_or(16) / 4};
}

std::uint32_t WordsIn::size(Id type) {
  const Instruction one = made(type);
  switch (one.op) {
    case SpvOpTypeVector:
      return one.operands[1];
    case SpvOpTypeMatrix:
      return one.operands[1] * 4;
    case SpvOpTypeArray:
      return module_.constant(one.operands[1]).value_or(1) * stride(type);
    case SpvOpTypeStruct: {
      const auto last = static_cast<std::uint32_t>(one.operands.size() - 1);
      return one.operands.empty() ? 0 : offset(type, last) + size(one.operands[last]);
    }
    default:
      return 1;
  }
}

WordsIn::Access WordsIn::access(Writing& writing, const PointerChain& chain) {
  Access found;
  found.type = made(module_.typeOf(chain.variable)).operands[1];
  found.what = plainName(module_.name(chain.variable));
  last_ = {};
  std::uint32_t constant = 0;
  Id sum = 0;
  const auto add = [&](Id index, std::uint32_t stride) {
    if (const auto known = module_.constant(index)) {
      constant += *known * stride;
      return;
    }
    const Id part =
        writing.emit(SpvOpIMul, module_.uintType(), {writing.asUint(index), module_.uintConstant(stride)});
    sum = sum == 0 ? part : writing.emit(SpvOpIAdd, module_.uintType(), {sum, part});
  };
  for (const Id index : chain.indices) {
    const Instruction one = made(found.type);
    const std::uint32_t member = module_.constant(index).value_or(0);
    switch (one.op) {
      case SpvOpTypeStruct: {
        constant += offset(found.type, member);
        last_ = matrix(found.type, member);
        const std::string name = module_.memberName(found.type, member);
        std::string& to = found.array == 0 ? found.what : found.part;
        if (!name.empty() && name[0] != '@') to = found.array != 0 && !to.empty() ? to + "." + name : name;
        if (found.array == 0) found.member = member;
        found.type = one.operands[member];
        break;
      }
      case SpvOpTypeArray:
      case SpvOpTypeRuntimeArray:
        add(index, stride(found.type));
        if (found.array == 0) {
          found.array = found.type;
          found.element = index;
        }
        found.type = one.operands[0];
        break;
      case SpvOpTypeMatrix:
        add(index, last_.byRows ? 1 : last_.stride);
        found.step = last_.byRows ? last_.stride : 1;
        found.type = one.operands[0];
        break;
      default:
        add(index, found.step);
        found.type = one.operands[0];
    }
  }
  const Id rest = module_.uintConstant(constant);
  found.first = sum == 0        ? rest
                : constant == 0 ? sum
                                : writing.emit(SpvOpIAdd, module_.uintType(), {sum, rest});
  found.element = writing.asInt(found.element == 0 ? module_.uintConstant(0) : found.element);
  return found;
}

std::vector<std::uint32_t> WordsIn::offsets(const Access& access) {
  std::vector<std::uint32_t> found;
  walk(access.type, 0, access.step, last_, found);
  return found;
}

void WordsIn::walk(Id type, std::uint32_t at, std::uint32_t step, const Matrix& matrix,
                   std::vector<std::uint32_t>& found) {
  const Instruction one = made(type);
  switch (one.op) {
    case SpvOpTypeVector:
      for (std::uint32_t i = 0; i < one.operands[1]; ++i) found.push_back(at + i * step);
      return;
    case SpvOpTypeMatrix:
      for (std::uint32_t i = 0; i < one.operands[1]; ++i)
        walk(one.operands[0], at + i * (matrix.byRows ? 1 : matrix.stride),
             matrix.byRows ? matrix.stride : 1, matrix, found);
      return;
    case SpvOpTypeArray:
      for (std::uint32_t i = 0; i < module_.constant(one.operands[1]).value_or(1); ++i)
        walk(one.operands[0], at + i * stride(type), step, matrix, found);
      return;
    case SpvOpTypeStruct:
      for (std::uint32_t i = 0; i < one.operands.size(); ++i)
        walk(one.operands[i], at + offset(type, i), 1, this->matrix(type, i), found);
      return;
    default:
      found.push_back(at);
  }
}

void WordsIn::parts(Writing& writing, Id value, Id type, Words& words) {
  const Instruction one = made(type);
  std::uint32_t count = 0;
  switch (one.op) {
    case SpvOpTypeVector:
    case SpvOpTypeMatrix:
      count = one.operands[1];
      break;
    case SpvOpTypeArray:
      count = module_.constant(one.operands[1]).value_or(1);
      break;
    case SpvOpTypeStruct:
      count = static_cast<std::uint32_t>(one.operands.size());
      break;
    case SpvOpTypeBool:
      words.push_back(
          writing.select(value, module_.uintType(), module_.uintConstant(1), module_.uintConstant(0)));
      return;
    default:
      words.push_back(writing.asUint(value));
      return;
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const Id part = one.op == SpvOpTypeStruct ? one.operands[i] : one.operands[0];
    parts(writing, writing.emit(SpvOpCompositeExtract, part, {value, i}), part, words);
  }
}

}  // namespace simreel::kernels

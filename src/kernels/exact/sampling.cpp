#include "kernels/exact/sampling.hpp"

#include "kernels/exact/calls.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

class Filtering {
 public:
  Filtering(Module& module, const std::set<Id>& cubes, bool only, bool careful)
      : module_(module), cubes_(cubes), only_(only), careful_(careful) {}

  void run() {
    std::vector<Instruction> body = std::move(module_.body);
    for (const Instruction& one : body) {
      if (one.op == SpvOpLoad) loaded_[one.result] = one.operands[0];
      if (one.op == SpvOpSampledImage) joined_[one.result] = {one.operands[0], one.operands[1]};
    }
    declare(body);
    module_.body.clear();
    for (Instruction& one : body) place(one);
    dropUnused();
    module_.index();
    if (calls_.empty()) return;
    module_.head.push_back({SpvOpCapability, 0, 0, {SpvCapabilityImageQuery}});
    linkLibrary(module_, calls_, careful_);
  }

 private:
  struct Pair {
    Id image = 0, sampler = 0;  ///< ids of the image variable and the sampler variable; the sampler is 0
                                ///< for a combined GLSL sampler
  };
  struct Read {
    Pair pair;
    std::string kind;  ///< type code of the texture in the mangled names of the library's filter functions
  };

  /// Returns the texture that an instruction reads if the library has a filter for its type.
  std::optional<Read> filtered(const Instruction& one) const {
    if (one.op != SpvOpImageSampleExplicitLod || one.operands.size() != 4 ||
        one.operands[2] != SpvImageOperandsLodMask)
      return std::nullopt;
    Pair pair;
    if (const auto found = joined_.find(one.operands[0]); found != joined_.end())
      pair = {variable(found->second.image), variable(found->second.sampler)};
    else
      pair = {variable(one.operands[0]), 0};
    if (pair.image == 0 || (joined_.contains(one.operands[0]) && pair.sampler == 0)) return std::nullopt;
    const Instruction* type = module_.global(module_.global(module_.typeOf(pair.image))->operands[1]);
    const bool withSampler = type->op == SpvOpTypeSampledImage;
    if (withSampler) type = module_.global(type->operands[0]);
    if (type->op != SpvOpTypeImage || module_.signature(type->operands[0]) != "f1" ||
        type->operands[2] == 1 || type->operands[4] == 1)
      return std::nullopt;
    const std::string place = module_.signature(module_.typeOf(one.operands[1]));
    const bool layers = type->operands[3] == 1, flat = type->operands[1] == SpvDim2D && !layers;
    if (module_.signature(one.type) != "vf4" ||
        module_.signature(module_.typeOf(one.operands[3])) != "f1" || place != (flat ? "vf2" : "vf3"))
      return std::nullopt;
    const char* letter = withSampler ? "s" : "t";
    if (cubes_.contains(pair.image)) return Read{pair, fmt::format("xCube({}A21;vf3;", letter)};
    if (only_) return std::nullopt;
    if (type->operands[1] == SpvDim2D)
      return Read{pair,
                  fmt::format("xSample({}{}21;{}", letter, layers ? "A" : "", layers ? "vf3;" : "vf2;")};
    if (type->operands[1] == SpvDim3D && !layers)
      return Read{pair, fmt::format("xSample({}31;vf3;", letter)};
    return std::nullopt;
  }

  /// Returns the global variable from which a value was loaded, or 0 for an array element or any other
  /// value.
  Id variable(Id value) const {
    const auto found = loaded_.find(value);
    if (found == loaded_.end()) return 0;
    const Instruction* made = module_.global(found->second);
    return made != nullptr && made->op == SpvOpVariable ? made->result : 0;
  }

  /// Declares a uniform block with one word for each pair of texture and sampler. The word holds filter and
  /// wrap mode.
  void declare(const std::vector<Instruction>& body) {
    std::vector<std::string> names;
    for (const Instruction& one : body) {
      const auto read = filtered(one);
      if (!read || members_.contains(key(read->pair))) continue;
      members_[key(read->pair)] = static_cast<std::uint32_t>(names.size());
      const std::string texture = module_.name(read->pair.image);
      names.push_back(read->pair.sampler == 0 ? texture : texture + "_" + module_.name(read->pair.sampler));
    }
    if (names.empty()) return;
    const Id block = module_.addGlobal(SpvOpTypeStruct, 0, Words(names.size(), module_.uintType()));
    module_.decorate(block, SpvDecorationBlock);
    name(SpvOpName, {block}, samplerBlock);
    for (std::uint32_t i = 0; i < names.size(); ++i) name(SpvOpMemberName, {block, i}, names[i]);
    const Id pointer = module_.globalOf(SpvOpTypePointer, 0, {SpvStorageClassUniform, block});
    block_ = module_.addGlobal(SpvOpVariable, pointer, {SpvStorageClassUniform});
    member_ = module_.globalOf(SpvOpTypePointer, 0, {SpvStorageClassUniform, module_.uintType()});
  }

  void name(SpvOp op, Words operands, const std::string& text) {
    const Words words = textWords(text);
    operands.insert(operands.end(), words.begin(), words.end());
    module_.head.push_back({op, 0, 0, std::move(operands)});
  }

  static std::uint64_t key(const Pair& pair) {
    return (static_cast<std::uint64_t>(pair.image) << 32U) | pair.sampler;
  }

  void place(Instruction& one) {
    const auto read = filtered(one);
    if (!read) {
      module_.body.push_back(std::move(one));
      return;
    }
    const Id index = module_.uintConstant(members_[key(read->pair)]);
    const Id at = module_.fresh(), state = module_.fresh();
    module_.body.push_back({SpvOpAccessChain, member_, at, {block_, index}});
    module_.body.push_back({SpvOpLoad, module_.uintType(), state, {at}});
    calls_.push_back({module_.body.size(), read->kind + "f1;u1;"});
    module_.body.push_back({SpvOpFunctionCall,
                            one.type,
                            one.result,
                            {0, read->pair.image, one.operands[1], one.operands[3], state}});
  }

  /// Removes unused sampled images, which would otherwise count as textures of the kernel.
  void dropUnused() {
    std::unordered_map<Id, std::size_t> uses;
    for (const Instruction& one : module_.body)
      for (std::size_t i = 0; i < one.operands.size(); ++i)
        if (isId(one, i)) ++uses[one.operands[i]];
    std::vector<Instruction> kept;
    std::vector<std::size_t> moved(module_.body.size());
    for (std::size_t i = 0; i < module_.body.size(); ++i) {
      moved[i] = kept.size();
      Instruction& one = module_.body[i];
      if (one.op != SpvOpSampledImage || uses.contains(one.result)) kept.push_back(std::move(one));
    }
    module_.body = std::move(kept);
    for (PlacedCall& call : calls_) call.at = moved[call.at];
  }

  Module& module_;
  const std::set<Id>& cubes_;
  bool only_;
  bool careful_;
  std::unordered_map<Id, Id> loaded_;
  std::unordered_map<Id, Pair> joined_;  ///< pairs of image and sampler, by the id of the sampled image
                                         ///< that combines them
  std::unordered_map<std::uint64_t, std::uint32_t> members_;
  Id block_ = 0, member_ = 0;
  std::vector<PlacedCall> calls_;
};

}  // namespace

void filterExactly(Module& module, const std::set<Id>& cubes, bool only, bool careful) {
  Filtering(module, cubes, only, careful).run();
}

}  // namespace simreel::kernels

// Links the library of exact functions into a user's module.
#include "gl/shader_source.hpp"
#include "kernels/compile/front_end.hpp"
#include "kernels/exact/calls.hpp"

#include <map>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

std::string textOf(bool careful) {
  gl::Defines defines = {{gl::extensionDefine, "GL_EXT_samplerless_texture_functions"}};
  if (careful) defines.emplace_back("CAREFUL", "1");
  return gl::loadShader("kernels/library.glsl", defines).text;
}

/// The compiled library, with the instruction range of each function.
struct Library {
  struct Function {
    std::size_t begin, end;
  };
  Module module;
  std::map<std::string, Id> names;
  std::unordered_map<Id, Function> functions;
  Id set = 0;  ///< id of the import of the instruction set GLSL.std.450

  explicit Library(bool careful) : module(compileLibrary(textOf(careful))) {
    forbidContraction(module);
    set = module.extendedSet();
    for (const Instruction& one : module.head)
      if (one.op == SpvOpName) names[literalText(std::span(one.operands).subspan(1))] = one.operands[0];
    for (std::size_t i = 0; i < module.body.size(); ++i)
      if (module.body[i].op == SpvOpFunction) {
        const std::size_t begin = i;
        while (module.body[i].op != SpvOpFunctionEnd) ++i;
        functions[module.body[begin].result] = {begin, i + 1};
      }
  }
};

const Library& library(bool careful) {
  if (careful) {
    static const Library compiled(true);
    return compiled;
  }
  static const Library compiled(false);
  return compiled;
}

class Linking {
 public:
  Linking(Module& module, const Library& library) : module_(module), library_(library) {}

  /// Returns the id in the user's module for the function that has the id `theirs` in the library. Appends
  /// the function at its first use.
  Id function(Id theirs) {
    if (const auto found = ids_.find(theirs); found != ids_.end()) return found->second;
    const Id mine = ids_[theirs] = module_.fresh();
    const auto [begin, end] = library_.functions.at(theirs);
    std::vector<Instruction> copied;
    for (std::size_t i = begin; i < end; ++i) copied.push_back(mapped(library_.module.body[i]));
    copied[0].operands[0] |= SpvFunctionControlDontInlineMask;
    for (Instruction& one : copied) pending_.push_back(std::move(one));
    named(theirs, mine);
    return mine;
  }

  void finish() {
    for (Instruction& one : pending_) module_.body.push_back(std::move(one));
    for (const Instruction& one : library_.module.decorations) {
      const auto found = ids_.find(one.operands[0]);
      if (found == ids_.end() || one.op != SpvOpDecorate) continue;
      if (one.operands[1] == SpvDecorationNoContraction)
        module_.decorate(found->second, SpvDecorationNoContraction);
    }
    module_.index();
  }

 private:
  Instruction mapped(const Instruction& theirs) {
    Instruction mine = theirs;
    if (mine.type != 0) mine.type = id(mine.type);
    for (std::size_t i = 0; i < mine.operands.size(); ++i)
      if (isId(theirs, i)) mine.operands[i] = id(mine.operands[i]);
    if (mine.result != 0) mine.result = id(mine.result);
    return mine;
  }

  Id id(Id theirs) {
    if (const auto found = ids_.find(theirs); found != ids_.end()) return found->second;
    if (library_.functions.contains(theirs)) return function(theirs);
    if (const Instruction* made = library_.module.global(theirs)) return global(*made);
    if (theirs == library_.set) return ids_[theirs] = module_.extendedSet();
    return ids_[theirs] = module_.fresh();
  }

  Id global(const Instruction& theirs) {
    Instruction mine = theirs;
    if (mine.type != 0) mine.type = id(mine.type);
    for (std::size_t i = 0; i < mine.operands.size(); ++i)
      if (isId(theirs, i)) mine.operands[i] = id(mine.operands[i]);
    const bool own =
        theirs.op == SpvOpTypeStruct || theirs.op == SpvOpTypeArray || theirs.op == SpvOpVariable;
    return ids_[theirs.result] = own ? module_.addGlobal(mine.op, mine.type, mine.operands)
                                     : module_.globalOf(mine.op, mine.type, mine.operands);
  }

  void named(Id theirs, Id mine) {
    for (const auto& [name, function] : library_.names) {
      if (function != theirs) continue;
      Words operands = {mine};
      const Words text = textWords(name.substr(0, name.find('(')));
      operands.insert(operands.end(), text.begin(), text.end());
      module_.head.push_back({SpvOpName, 0, 0, std::move(operands)});
    }
  }

  Module& module_;
  const Library& library_;
  std::unordered_map<Id, Id> ids_;
  std::vector<Instruction> pending_;
};

}  // namespace

void linkLibrary(Module& module, const std::vector<PlacedCall>& calls, bool careful) {
  if (calls.empty()) return;
  const Library& exact = library(careful);
  Linking linking(module, exact);
  for (const PlacedCall& call : calls) {
    const auto found = exact.names.find(call.function);
    if (found == exact.names.end())
      throw std::runtime_error(fmt::format("there is no exact function {}", call.function));
    module.body[call.at].operands[0] = linking.function(found->second);
  }
  linking.finish();
}

}  // namespace simreel::kernels

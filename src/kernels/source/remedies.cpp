#include "kernels/source/remedies.hpp"

#include "kernels/source/files.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

bool assigns(std::string_view text) {
  return text == "=" || text == "++" || text == "--" || text == "<<=" || text == ">>=" ||
         (text.size() == 2 && text[1] == '=' &&
          std::string_view("+-*/%&|^").find(text[0]) != std::string_view::npos);
}

/// Returns the index of the token after the members and indices that follow a name at token `i`.
std::size_t behindMembers(const std::vector<Token>& all, std::size_t i) {
  while (i < all.size()) {
    if (all[i].text == "." && i + 1 < all.size()) {
      i += 2;
    } else if (all[i].text == "[") {
      for (int depth = 0; i < all.size();) {
        depth += all[i].text == "[" ? 1 : all[i].text == "]" ? -1 : 0;
        ++i;
        if (depth == 0) break;
      }
    } else {
      break;
    }
  }
  return i;
}

/// If the shader assigns to `a`, changes "float a, b;" to "float simreel_constant_a, b; static float a =
/// simreel_constant_a;".
void makeVariables(const Declaration& one, const Remedies& remedies, Edits& edits) {
  if (one.shared || one.constant) return;
  for (const Declarator& name : one.names) {
    if (remedies.assigned.find(name.name) == remedies.assigned.end()) continue;
    edits.insert(name.at, std::string(constantPrefix));
    edits.insert(one.end, fmt::format(" static {} {}{} = {}{};", one.type, name.name, name.lengths,
                                      constantPrefix, name.name));
  }
}

void undefineFirst(const std::string& text, std::size_t file, const Remedies& remedies, Edits& edits) {
  int number = 1;
  std::size_t begin = 0;
  for (const auto& [of, line] : remedies.redefined) {
    if (of != file) continue;
    for (; number < line && begin != std::string::npos; ++number) {
      const std::size_t end = text.find('\n', begin);
      begin = end == std::string::npos ? end : end + 1;
    }
    if (begin == std::string::npos) return;
    const std::size_t word = text.find("define", begin);
    if (word == std::string::npos) return;
    const std::size_t name = text.find_first_not_of(" \t", word + 6);
    const std::size_t end = text.find_first_of(" \t\n(", name);
    if (name == std::string::npos) return;
    edits.insert(begin, fmt::format("#undef {}\n#line {}\n", text.substr(name, end - name), line));
  }
}

/// Inserts "N_" before names of functions of the namespace N between two tokens.
void prefix(const std::vector<Token>& all, std::size_t first, std::size_t last, const Remedies& remedies,
            Edits& edits) {
  for (std::size_t i = first + 3; i < last; ++i)
    if (remedies.prefixed.contains(all[i].text) && all[i - 1].text != "." && all[i - 1].text != "::")
      edits.insert(all[i].at, std::string(all[first + 1].text) + "_");
}

/// Blanks "namespace N {", the matching "}", and "N::".
void dissolve(const std::vector<Token>& all, const Remedies& remedies, Edits& edits) {
  const auto blank = [&](std::size_t first, std::size_t last) {
    edits.replace(all[first].at, all[last].end(), std::string(all[last].end() - all[first].at, ' '));
  };
  for (std::size_t i = 0; i + 2 < all.size(); ++i) {
    if (all[i].text == "namespace" && all[i + 2].text == "{") {
      const auto end = std::find_if(
          all.begin() + static_cast<std::ptrdiff_t>(i) + 3, all.end(),
          [&](const Token& one) { return one.text == "}" && one.depth <= all[i + 2].depth + 1; });
      if (end == all.end()) continue;
      blank(i, i + 2);
      const auto close = static_cast<std::size_t>(end - all.begin());
      blank(close, close);
      prefix(all, i, close, remedies, edits);
    } else if (all[i + 1].text == "::" && remedies.dissolved.contains(all[i].text)) {
      blank(i, i + 1);
      if (remedies.prefixed.contains(all[i + 2].text))
        edits.insert(all[i + 2].at, std::string(all[i].text) + "_");
    }
  }
}

}  // namespace

std::set<std::string, std::less<>> assignedNames(const std::vector<Token>& all) {
  std::set<std::string, std::less<>> names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].isWord()) continue;
    const std::string_view before = i == 0 ? "" : all[i - 1].text;
    if (before == ".") continue;
    const std::size_t behind = behindMembers(all, i + 1);
    const bool after = behind < all.size() && assigns(all[behind].text);
    if (after || before == "++" || before == "--") names.emplace(all[i].text);
  }
  return names;
}

std::string lengthFunction(std::string_view type, std::string_view name) {
  struct Kind {
    std::string_view begin;
    int sizes;
    bool stride;
  };
  static constexpr Kind kinds[] = {{"Texture1DArray", 2, false},
                                   {"Texture1D", 1, false},
                                   {"Texture2DArray", 3, false},
                                   {"Texture2D", 2, false},
                                   {"Texture3D", 3, false},
                                   {"TextureCube", 2, false},
                                   {"StructuredBuffer", 1, true},
                                   {"ByteAddressBuffer", 1, false},
                                   {"Buffer", 1, false},
                                   {"AppendStructuredBuffer", 1, true},
                                   {"ConsumeStructuredBuffer", 1, true}};
  if (type.starts_with("RW")) type.remove_prefix(2);
  for (const Kind& kind : kinds) {
    if (!type.starts_with(kind.begin)) continue;
    const std::string arguments = kind.stride       ? "n.x, n.y"
                                  : kind.sizes == 1 ? "n.x"
                                  : kind.sizes == 2 ? "n.x, n.y"
                                                    : "n.x, n.y, n.z";
    static constexpr const char* results[] = {"uint", "uint2", "uint3"};
    static constexpr const char* parts[] = {"x", "xy", "xyz"};
    return fmt::format(" {} simreel_length_{}() {{ uint3 n = 0; {}.GetDimensions({}); return n.{}; }}",
                       results[kind.sizes - 1], name, name, arguments, parts[kind.sizes - 1]);
  }
  return {};
}

/// Declarations for Direct3D 9, in which a texture contains its sampler, and the functions that read such
/// textures. The scene sets the filter.
constexpr const char* directX9 = R"(SamplerState simreel_linear_repeat;
#define sampler2D Texture2D<float4>
#define sampler3D Texture3D<float4>
#define tex2D(s, at) s.SampleLevel(simreel_linear_repeat, (at).xy, 0)
#define tex2Dlod(s, at) s.SampleLevel(simreel_linear_repeat, (at).xy, (at).w)
#define tex3D(s, at) s.SampleLevel(simreel_linear_repeat, (at).xyz, 0)
#define tex3Dlod(s, at) s.SampleLevel(simreel_linear_repeat, (at).xyz, (at).w)
)";

std::string functionMacros(const Remedies& remedies) {
  struct Macro {
    std::string_view name, text;
  };
  static constexpr Macro macros[] = {
      {"select", "#define select(a, b, c) ((a) ? (b) : (c))\n"},
      {"and", "#define and(a, b) ((a) && (b))\n"},
      {"or", "#define or(a, b) ((a) || (b))\n"},
      {"NonUniformResourceIndex", "#define NonUniformResourceIndex(a) (a)\n"},
      {"tex2D", directX9}};
  std::string text;
  for (const Macro& macro : macros)
    if (remedies.functions.find(macro.name) != remedies.functions.end()) text += macro.text;
  return text;
}

std::string remedied(const std::string& text, std::size_t file, const Remedies& remedies) {
  if (remedies.count() == 0) return text;
  const std::string code = withoutComments(text);
  const std::vector<Token> all = tokens(code);
  Edits edits;
  for (const Declaration& one : globals(code, all)) {
    makeVariables(one, remedies, edits);
    for (const Declarator& name : one.names)
      if (remedies.measured.find(name.name) != remedies.measured.end())
        edits.insert(one.end, lengthFunction(one.type, name.name));
  }
  for (std::size_t i = 0; i + 2 < all.size(); ++i)
    if (all[i + 1].text == "." && all[i + 2].text == "Length" &&
        remedies.measured.find(all[i].text) != remedies.measured.end() &&
        (i == 0 || all[i - 1].text != "."))
      edits.replace(all[i].at, all[i + 2].end(), fmt::format("simreel_length_{}()", all[i].text));
  if (!remedies.dissolved.empty()) dissolve(all, remedies, edits);
  if (const auto more = remedies.edits.find(file); more != remedies.edits.end()) edits.add(more->second);
  undefineFirst(text, file, remedies, edits);
  return edits.applied(text);
}

}  // namespace simreel::kernels

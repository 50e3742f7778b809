#include "kernels/source/dialect.hpp"

#include "kernels/source/files.hpp"
#include "kernels/source/tokens.hpp"

#include <cstddef>
#include <set>
#include <string_view>
#include <vector>

namespace simreel::kernels {

namespace {

/// Replaces "unsigned int3" by "uint3" and "unsigned" by "uint".
void shortenUnsigned(const std::vector<Token>& all, Edits& edits) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].text != "unsigned") continue;
    const bool withType = i + 1 < all.size() && all[i + 1].text.starts_with("int");
    edits.replace(all[i].at, all[i].end(), withType ? "" : "uint");
    if (withType) edits.insert(all[i + 1].at, "u");
  }
}

/// Replaces typed buffers, such as "Buffer<float4>", by structured buffers. Both types read and write whole
/// elements.
void restructure(const std::vector<Token>& all, Edits& edits) {
  for (std::size_t i = 0; i + 1 < all.size(); ++i)
    if ((all[i].text == "Buffer" || all[i].text == "RWBuffer") && all[i + 1].text == "<")
      edits.insert(all[i].at + all[i].text.size() - std::string_view("Buffer").size(), "Structured");
}

/// Returns the index of the token that closes the braces at or after token `i`. Returns the token count if
/// the braces are not closed.
std::size_t closing(const std::vector<Token>& all, std::size_t i) {
  while (i < all.size() && (all[i].text != "{" || all[i].directive)) ++i;
  const int outside = i < all.size() ? all[i].depth : 0;
  for (++i; i < all.size(); ++i)
    if (all[i].text == "}" && all[i].depth == outside + 1 && !all[i].directive) return i;
  return all.size();
}

/// Moves groupshared variables out of constant buffers. A constant buffer that becomes empty is removed.
void moveSharedOut(std::string_view code, const std::vector<Token>& all, Edits& edits) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].text != "cbuffer" || all[i].directive) continue;
    const std::size_t close = closing(all, i);
    if (close == all.size()) continue;
    std::string moved;
    Edits inside;
    std::size_t left = 0;
    std::size_t k = i;
    while (all[k].text != "{") ++k;
    for (++k; k < close; ++k) {
      const std::size_t begin = all[k].at;
      const bool shared = all[k].text == "groupshared";
      while (k < close && all[k].text != ";") ++k;
      if (k == close) return;
      if (shared) {
        moved += " " + std::string(code.substr(begin, all[k].end() - begin));
        inside.replace(begin, all[k].end(), "");
      } else {
        ++left;
      }
    }
    if (moved.empty()) continue;
    for (char& c : moved)
      if (c == '\n') c = ' ';
    const bool semicolon = close + 1 < all.size() && all[close + 1].text == ";";
    const std::size_t end = all[semicolon ? close + 1 : close].end();
    if (left == 0)
      edits.replace(all[i].at, end, moved);
    else {
      edits.add(inside);
      edits.insert(end, (semicolon ? "" : ";") + moved);
    }
    i = close;
  }
}

/// Blanks "interface I {...};", and ": I" after the name of a class or struct that implements I.
void takeOutInterfaces(const std::vector<Token>& all, Edits& edits) {
  std::set<std::string_view> interfaces;
  const auto blank = [&](std::size_t first, std::size_t last) {
    edits.replace(all[first].at, all[last].end(), "");
  };
  for (std::size_t i = 0; i + 3 < all.size(); ++i) {
    if (all[i].text == "interface") {
      const std::size_t close = closing(all, i);
      if (close == all.size()) return;
      interfaces.insert(all[i + 1].text);
      const bool semicolon = close + 1 < all.size() && all[close + 1].text == ";";
      blank(i, semicolon ? close + 1 : close);
    } else if ((all[i].text == "class" || all[i].text == "struct") && all[i + 2].text == ":" &&
               interfaces.contains(all[i + 3].text)) {
      std::size_t last = i + 3;
      while (last + 2 < all.size() && all[last + 1].text == "," && interfaces.contains(all[last + 2].text))
        last += 2;
      blank(i + 2, last);
    }
  }
}

}  // namespace

std::string dialect(const std::string& text) {
  const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
  if (!has("unsigned") && !has("groupshared") && !has("interface") && !has("Buffer")) return text;
  const std::string code = withoutComments(text);
  const std::vector<Token> all = tokens(code);
  Edits edits;
  shortenUnsigned(all, edits);
  moveSharedOut(code, all, edits);
  takeOutInterfaces(all, edits);
  restructure(all, edits);
  return edits.applied(text);
}

}  // namespace simreel::kernels

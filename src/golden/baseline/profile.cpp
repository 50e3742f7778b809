#include "golden/baseline/profile.hpp"

#include <algorithm>
#include <regex>
#include <string_view>
#include <utility>
#include <vector>

namespace simreel::golden {

namespace {

constexpr std::size_t maxCharacters = 32;

bool isWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

std::string lowered(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Returns the words of a text. A word is a maximal sequence of letters and digits.
std::vector<std::string> wordsOf(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (isWordCharacter(c))
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

/// Joins words with '-' and cuts the result to the max length.
std::string nameOf(const std::vector<std::string>& words) {
  std::string name;
  for (const std::string& word : words) name += (name.empty() ? "" : "-") + word;
  if (name.size() > maxCharacters) name.resize(maxCharacters);
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name.empty() ? "unknown" : name;
}

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

bool matches(const std::string& text, const char* pattern) {
  return std::regex_search(text, std::regex(pattern, std::regex::ECMAScript));
}

/// Returns the name of NVIDIA's architecture for a product. The first matching pattern counts, because
/// names overlap. For example, "Quadro RTX 4000" (Turing), "RTX 4000 Ada" and "GeForce RTX 4090" have words
/// in common, and the GeForce RTX 2050 is an Ampere.
std::string nvidiaName(const std::string& renderer) {
  struct Family {
    const char* pattern;
    const char* name;
  };
  constexpr Family families[] = {
      {R"(\b(quadro|titan) rtx\b)", "turing"},
      {R"(\bblackwell\b|\bg?b[123]00\b|\bgb10\b)", "blackwell"},
      {R"(\bada\b|\bl(2|4|20|40|40s)\b|\brtx 40\d\d)", "ada"},
      {R"(\brtx 50\d\d)", "blackwell"},
      {R"(\bg?h(20|100|200|800)\b)", "hopper"},
      {R"(\ba(2|10|10g|10m|16|30|40|100|800)\b|\brtx a\d{3,4}\b|\brtx (30\d\d|2050))", "ampere"},
      {R"(\bt4g?\b|\bt\d{3,4}\b|\brtx 20\d\d|\bgtx 16\d\d)", "turing"},
      {R"(\bg?v100s?\b|\btitan v\b)", "volta"},
      {R"(\bg?p(4|6|40|100)\b|\bquadro p\d{3,4}\b|\bgtx? 10\d\d|\btitan xp\b|\(pascal\))", "pascal"},
  };
  for (const Family& family : families)
    if (matches(renderer, family.pattern)) return std::string("nvidia-") + family.name;
  // In "NVIDIA GeForce GTX 970/PCIe/SSE2", the part from the slash on names the bus and the processor.
  std::vector<std::string> words = wordsOf(renderer.substr(0, renderer.find('/')));
  std::erase(words, "nvidia");
  std::erase(words, "corporation");
  words.insert(words.begin(), "nvidia");
  return nameOf(words);
}

/// Splits a text into the part before its last parentheses and the text inside them.
std::pair<std::string, std::string> splitParentheses(const std::string& text) {
  const std::size_t open = text.rfind('(');
  const std::size_t close = text.rfind(')');
  if (open == std::string::npos || close == std::string::npos || close < open) return {text, ""};
  return {text.substr(0, open), text.substr(open + 1, close - open - 1)};
}

/// Returns the name of an AMD chip. Mesa reports it in parentheses: "AMD Radeon RX 6700 XT (radeonsi,
/// navi22, LLVM 15.0.7, DRM 3.49)".
std::string amdName(const std::string& renderer) {
  const auto [product, details] = splitParentheses(renderer);
  if (has(details, ",")) {
    const std::size_t at = details.starts_with("radeonsi, ") ? std::string_view("radeonsi, ").size() : 0;
    const std::vector<std::string> chip = wordsOf(details.substr(at, details.find(',', at) - at));
    if (chip.size() == 1) return nameOf({"amd", chip[0]});
  }
  std::vector<std::string> words = wordsOf(has(details, ",") ? product : renderer);
  std::erase_if(words,
                [](const std::string& word) { return word == "amd" || word == "tm" || word == "mesa"; });
  words.insert(words.begin(), "amd");
  return nameOf(words);
}

/// Returns the name of an Intel device, such as "Mesa Intel(R) UHD Graphics 630 (CFL GT2)". This is the
/// product name if it contains a number, and otherwise the product name and the chip name.
std::string intelName(const std::string& renderer) {
  auto [product, chip] = splitParentheses(renderer);
  if (chip == "r" || chip == "tm") product = renderer, chip.clear();
  std::vector<std::string> words = wordsOf(product);
  const auto found = [&](const char* word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  if (found("arc")) return "intel-arc";
  if (found("xe")) return "intel-xe";
  constexpr std::string_view noise[] = {"mesa",     "dri", "intel",      "r",          "tm",
                                        "graphics", "gpu", "opensource", "corporation"};
  std::erase_if(words, [&](const std::string& word) {
    return std::find(std::begin(noise), std::end(noise), word) != std::end(noise);
  });
  const bool numbered = std::any_of(words.begin(), words.end(),
                                    [](const std::string& word) { return matches(word, R"(\d)"); });
  if (!numbered)
    for (const std::string& word : wordsOf(chip)) words.push_back(word);
  words.insert(words.begin(), "intel");
  return nameOf(words);
}

}  // namespace

std::string profileName(const std::string& renderer, bool fma) {
  const std::string text = lowered(renderer);
  // Handles drivers layered on another driver, such as "zink Vulkan 1.3(AMD Radeon RX 7800 XT (RADV
  // NAVI32))".
  for (const char* layer : {"zink", "d3d12", "virgl"}) {
    const std::size_t open = text.find('(');
    if (!text.starts_with(layer) || open == std::string::npos) continue;
    const std::string below = text.substr(open + 1, text.rfind(')') - open - 1);
    return nameOf({layer, profileName(below, fma)});
  }
  if (has(text, "llvmpipe")) return fma ? "llvmpipe-fma" : "llvmpipe";
  if (has(text, "softpipe")) return "softpipe";
  if (matches(text, R"(\b(nvidia|geforce|quadro|tesla|titan|grid)\b)")) return nvidiaName(text);
  // Since Mesa 22.2 some devices report only the chip: "NAVI22 (navi22, LLVM 14.0.6, DRM 3.48, ...)".
  if (matches(text, R"(\b(amd|ati|radeon|radeonsi|firepro)\b|, drm \d)")) return amdName(text);
  if (matches(text, R"(\bintel\b)")) return intelName(text);
  return nameOf(wordsOf(text));
}

bool processorHasFma() {
#if defined(__x86_64__) || defined(__i386__)
  return __builtin_cpu_supports("fma") != 0;
#else
  return true;
#endif
}

std::string ownProfile(const std::string& renderer) {
  return profileName(renderer, processorHasFma());
}

}  // namespace simreel::golden

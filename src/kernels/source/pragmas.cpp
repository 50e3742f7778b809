#include "kernels/source/pragmas.hpp"

#include "base/file.hpp"
#include "kernels/source/plain.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace simreel::kernels {

namespace {

/// Returns the words after "#pragma", or an empty list for other lines.
std::vector<std::string> pragmaWords(const std::string& line) {
  const std::size_t sharp = line.find_first_not_of(" \t");
  if (sharp == std::string::npos || line[sharp] != '#') return {};
  std::istringstream words(line.substr(sharp + 1));
  std::vector<std::string> found;
  for (std::string word; words >> word;) found.push_back(word);
  if (found.empty() || found[0] != "pragma") return {};
  found.erase(found.begin());
  return found;
}

Announced announced(const std::vector<std::string>& words, int line) {
  Announced kernel{words[1], {}, line};
  for (std::size_t i = 2; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    if (equals == std::string::npos)
      kernel.defines.emplace_back(words[i], "1");
    else
      kernel.defines.emplace_back(words[i].substr(0, equals), words[i].substr(equals + 1));
  }
  return kernel;
}

/// True if a function can be a kernel. A kernel returns nothing, and its parameters have semantics. `name`:
/// position of the function's name. `open`: position of the bracket after the name.
bool canBeKernel(const std::string& code, std::size_t name, std::size_t open) {
  std::size_t last = name;
  while (last > 0 && std::isspace(static_cast<unsigned char>(code[last - 1])) != 0) --last;
  if (last < 4 || code.compare(last - 4, 4, "void") != 0) return false;
  const std::size_t close = code.find(')', open);
  std::istringstream parameters(
      code.substr(open + 1, close == std::string::npos ? close : close - open - 1));
  for (std::string one; std::getline(parameters, one, ',');)
    if (one.find_first_not_of(" \t\r\n") != std::string::npos && one.find(':') == std::string::npos)
      return false;
  return true;
}

/// Returns the functions that follow "[numthreads(x, y, z)]".
std::vector<Announced> withThreadGroups(const std::string& code) {
  std::vector<Announced> kernels;
  for (std::size_t at = code.find("numthreads"); at != std::string::npos;
       at = code.find("numthreads", at + 1)) {
    std::size_t end = code.find(']', at);
    const std::size_t open = end == std::string::npos ? end : code.find('(', end);
    if (open == std::string::npos) break;
    std::size_t last = open;
    while (last > end && std::isspace(static_cast<unsigned char>(code[last - 1])) != 0) --last;
    std::size_t first = last;
    while (first > end && partOfName(code[first - 1])) --first;
    if (first == last || !canBeKernel(code, first, open)) continue;
    const auto line = 1 + std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(first), '\n');
    kernels.push_back({code.substr(first, last - first), {}, static_cast<int>(line)});
  }
  return kernels;
}

/// Detects the language. GLSL contains "#version", HLSL contains "numthreads". For other texts the file
/// extension decides.
Language languageOf(const Files& files, const std::string& code) {
  if (code.find("#version") != std::string::npos) return Language::glsl;
  if (code.find("numthreads") != std::string::npos) return Language::hlsl;
  const std::string extension = lowerExtension(files.name(0));
  const bool glsl =
      extension == ".comp" || extension == ".glsl" || extension == ".frag" || extension == ".cs";
  return glsl ? Language::glsl : Language::hlsl;
}

}  // namespace

std::vector<std::string> Announcements::held(const std::vector<std::string>& chosen,
                                             std::vector<std::string>& unknown) const {
  std::vector<std::string> result;
  for (const auto& list : keywords) {
    const auto picked = std::find_if(list.rbegin(), list.rend(), [&](const std::string& keyword) {
      return std::find(chosen.begin(), chosen.end(), keyword) != chosen.end();
    });
    const std::string& keyword = picked == list.rend() ? list.front() : *picked;
    if (keyword.find_first_not_of('_') != std::string::npos) result.push_back(keyword);
  }
  for (const std::string& one : chosen)
    if (std::none_of(keywords.begin(), keywords.end(), [&](const auto& list) {
          return std::find(list.begin(), list.end(), one) != list.end();
        }))
      unknown.push_back(one);
  return result;
}

Announcements announcements(const Files& files) {
  const std::string code = withoutComments(files.text(0));
  Announcements found;
  found.language = languageOf(files, code);
  if (found.language == Language::glsl) {
    found.kernels.push_back({"main", {}, 1});
    return found;
  }
  std::istringstream lines(code);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::vector<std::string> words = pragmaWords(line);
    if (words.size() < 2) continue;
    if (words[0] == "kernel") words[1].erase(words[1].find_last_not_of(";,") + 1);
    if (words[0] == "kernel" &&
        std::none_of(found.kernels.begin(), found.kernels.end(),
                     [&](const Announced& kernel) { return kernel.name == words[1]; }))
      found.kernels.push_back(announced(words, number));
    if (words[0].starts_with("multi_compile") || words[0].starts_with("shader_feature")) {
      std::vector<std::string> list(words.begin() + 1, words.end());
      // A shader_feature with a single keyword may also be off.
      if (words[0].starts_with("shader_feature") && list.size() == 1) list.insert(list.begin(), "_");
      found.keywords.push_back(std::move(list));
    }
  }
  if (found.kernels.empty()) found.kernels = withThreadGroups(code);
  return found;
}

std::string entryName(std::string& text, const std::string& kernel, bool always) {
  const std::string code = withoutComments(text);
  std::size_t definitions = 0, own = std::string::npos;
  for (std::size_t at = code.find(kernel); at != std::string::npos; at = code.find(kernel, at + 1)) {
    const std::size_t end = code.find_first_not_of(" \t\n", at + kernel.size());
    if ((at > 0 && partOfName(code[at - 1])) || end == std::string::npos || code[end] != '(') continue;
    const std::size_t last = at == 0 ? std::string::npos : code.find_last_not_of(" \t\n", at - 1);
    if (last == std::string::npos || !partOfName(code[last]) || last + 1 == at) continue;
    std::size_t first = last;
    while (first > 0 && partOfName(code[first - 1])) --first;
    const std::string type = code.substr(first, last + 1 - first);
    if (type == "return" || type == "else") continue;
    ++definitions;
    const std::size_t before = first == 0 ? std::string::npos : code.find_last_not_of(" \t\n", first - 1);
    if (type == "void" && before != std::string::npos && code[before] == ']') own = at;
  }
  if ((definitions < 2 && !always) || own == std::string::npos) return kernel;
  text.replace(own, kernel.size(), kernel + "_kernel");
  return kernel + "_kernel";
}

}  // namespace simreel::kernels

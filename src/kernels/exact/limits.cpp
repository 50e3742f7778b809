#include "kernels/exact/limits.hpp"

#include "kernels/source/plain.hpp"
#include "kernels/source/scan.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

constexpr std::uint64_t maxPrivate = 1 << 20, maxShared = 32768;
constexpr std::uint32_t maxThreads = 1024;
constexpr std::array<std::uint32_t, 3> maxAlong = {1024, 1024, 64};

std::uint64_t bytesOf(const Module& module, Id type) {
  constexpr std::uint64_t maximum = std::uint64_t{1} << 40;
  const Instruction& made = *module.global(type);
  const auto times = [&](Id one, std::uint64_t count) {
    const std::uint64_t bytes = std::max<std::uint64_t>(1, bytesOf(module, one));
    return count > maximum / bytes ? maximum : bytes * count;
  };
  switch (made.op) {
    case SpvOpTypeFloat:
    case SpvOpTypeInt:
      return made.operands[0] / 8;
    case SpvOpTypeVector:
    case SpvOpTypeMatrix:
      return times(made.operands[0], made.operands[1]);
    case SpvOpTypeArray:
      return times(made.operands[0], module.constant(made.operands[1]).value_or(1));
    case SpvOpTypeStruct: {
      std::uint64_t sum = 0;
      for (const Id member : made.operands) sum += bytesOf(module, member);
      return std::min(sum, maximum);
    }
    default:
      return 4;
  }
}

/// Returns the position of the first line that contains `word` after one of the words in `others`. If
/// `others` is empty, `word` must be followed by '['. If there is no such line, returns line `otherwise` of
/// the first file.
Mistake at(const Files& files, const std::string& word, std::initializer_list<std::string_view> others,
           int otherwise) {
  for (std::size_t file = 0; file < files.count(); ++file) {
    const std::string code = withoutComments(files.text(file));
    for (std::size_t found = code.find(word); found != std::string::npos;
         found = code.find(word, found + 1)) {
      if ((found > 0 && partOfName(code[found - 1])) ||
          (found + word.size() < code.size() && partOfName(code[found + word.size()])))
        continue;
      const std::size_t begin = found == 0 ? 0 : code.rfind('\n', found - 1) + 1;
      const std::string_view before = std::string_view(code).substr(begin, found - begin);
      const std::size_t behind = code.find_first_not_of(" \t", found + word.size());
      const bool array = behind != std::string::npos && code[behind] == '[';
      if (others.size() == 0 ? array : std::any_of(others.begin(), others.end(), [&](std::string_view one) {
            return before.find(one) != std::string_view::npos;
          }))
        return {file,
                1 + static_cast<int>(
                        std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(begin), '\n')),
                word,
                {}};
    }
  }
  return {0, otherwise, {}, {}};
}

Mistake said(Mistake mistake, std::string message) {
  mistake.message = std::move(message);
  return mistake;
}

/// Returns the position of the [numthreads] attribute of function `entry` in the first file, or line
/// `otherwise`.
Mistake attributeOf(const Files& files, const std::string& entry, int otherwise) {
  const std::string code = withoutComments(files.text(0));
  for (std::size_t found = code.find(entry); found != std::string::npos;
       found = code.find(entry, found + 1)) {
    const std::size_t attribute = code.rfind("numthreads", found);
    if (attribute == std::string::npos || code.find_first_of(";{}", attribute) < found) continue;
    const auto begin = code.begin();
    return {0,
            1 + static_cast<int>(std::count(begin, begin + static_cast<std::ptrdiff_t>(attribute), '\n')),
            "numthreads",
            {}};
  }
  return {0, otherwise, {}, {}};
}

/// Returns mistakes in [numthreads(x, y, z)]. `mode`: instruction with the three numbers. glslang leaves
/// out numbers that it cannot represent.
std::vector<Mistake> beyondThreads(const Instruction& mode, Mistake place) {
  std::array<std::uint32_t, 3> threads{};
  for (std::size_t i = 0; i < 3; ++i) threads[i] = i + 2 < mode.operands.size() ? mode.operands[i + 2] : 0;
  std::uint64_t all = 1;
  bool fits = true;
  for (std::size_t i = 0; i < 3; ++i) {
    all *= std::min<std::uint32_t>(threads[i], 1U << 20U);
    fits = fits && threads[i] >= 1 && threads[i] <= maxAlong[i];
  }
  if (fits && all <= maxThreads) return {};
  return {said(std::move(place),
               fmt::format("a group has 1 to {} threads, at most {} along x and y, and {} along z",
                           maxThreads, maxAlong[0], maxAlong[2]))};
}

/// Returns the words before `end`, back to the last ";", "{" or "}", without preprocessor lines. If an
/// included file has none of these before `end`, the words before its #include line come first.
std::string leadOf(const Files& files, std::size_t file, std::size_t end) {
  const std::string code = withoutComments(files.text(file));
  const std::size_t last = code.find_last_of(";{}", end), begin = last == std::string::npos ? 0 : last + 1;
  std::istringstream lines(code.substr(begin, end - begin));
  std::string lead;
  const std::string own = std::filesystem::path(files.name(file)).filename().string();
  for (std::size_t i = 0; begin == 0 && file > 0 && i < file && lead.empty(); ++i) {
    const std::string& other = files.text(i);
    const std::size_t name = other.find(own + "\"");
    const std::size_t sharp = name == std::string::npos ? name : other.rfind('#', name);
    if (sharp != std::string::npos && sharp > 0) lead = leadOf(files, i, sharp - 1);
  }
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    for (std::string word; words >> word && word[0] != '#';) lead += (lead.empty() ? "" : " ") + word;
  }
  return lead;
}

bool isWordAt(const std::string& code, std::size_t begin, std::size_t length) {
  const auto part = [&](std::size_t i) {
    return i < code.size() && (std::isalnum(static_cast<unsigned char>(code[i])) != 0 || code[i] == '_');
  };
  return (begin == 0 || !part(begin - 1)) && !part(begin + length);
}

}  // namespace

std::vector<Mistake> withoutGroups(const Files& files, const std::string& entry) {
  std::vector<Mistake> mistakes;
  for (std::size_t file = 0; file < files.count(); ++file) {
    const std::string code = withoutComments(files.text(file));
    for (std::size_t at = code.find(entry); at != std::string::npos; at = code.find(entry, at + 1)) {
      const std::size_t behind = code.find_first_not_of(" \t\r\n", at + entry.size());
      if (!isWordAt(code, at, entry.size()) || behind == std::string::npos || code[behind] != '(') continue;
      const std::string lead = leadOf(files, file, at);
      // A macro before "void" may contain the attribute.
      if (lead.find("numthreads") != std::string::npos) return {};
      if (lead == "void" && mistakes.empty())
        mistakes.push_back(
            {file,
             1 + static_cast<int>(
                     std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(at), '\n')),
             entry,
             fmt::format(
                 "kernel {} has no [numthreads(x, y, z)] before it, the size of its groups; write one, "
                 "such as [numthreads(64, 1, 1)]",
                 scene::inQuotes(entry))});
    }
  }
  return mistakes;
}

std::vector<Mistake> variableGroups(const Files& files, const std::string& entry) {
  const std::string code = withoutComments(files.text(0));
  const std::vector<Token> all = tokens(code);
  std::vector<Mistake> mistakes;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    if (all[i].text != "numthreads" || all[i].directive) continue;
    std::size_t function = closingBracket(all, i + 1) + 1;  // token after the attribute
    while (function + 1 < all.size() && all[function + 1].text != "(") ++function;
    if (function >= all.size() || all[function].text != entry) continue;
    for (std::size_t k = i + 2; k < all.size() && all[k].text != ")"; ++k)
      for (std::size_t d = 1; all[k].isWord() && d + 1 < all.size(); ++d) {
        if (all[d].text != all[k].text || all[d + 1].text != ";" || !numeric(all[d - 1].text)) continue;
        const auto begin = code.begin();
        mistakes.push_back(
            {0,
             1 + static_cast<int>(std::count(begin, begin + static_cast<std::ptrdiff_t>(all[k].at), '\n')),
             std::string(all[k].text),
             fmt::format("the size of groups is a number, a macro or a static const, and {} is a constant "
                         "that a scene sets",
                         scene::inQuotes(all[k].text))});
        break;
      }
  }
  return mistakes;
}

std::vector<Mistake> withoutLocalSize(const Files& files) {
  std::size_t file = 0, id = std::string::npos, idFile = 0;
  for (; file < files.count(); ++file) {
    const std::string code = withoutComments(files.text(file));
    for (const char* axis : {"local_size_x", "local_size_y", "local_size_z"})
      for (std::size_t at = code.find(axis); at != std::string::npos; at = code.find(axis, at + 1)) {
        if (isWordAt(code, at, std::strlen(axis))) return {};
        id = at;
        idFile = file;
      }
  }
  if (id == std::string::npos)
    return {{0,
             1,
             {},
             "the shader has no size of its groups; write one, such as layout(local_size_x = 64) in;"}};
  const std::string& text = files.text(idFile);
  const auto begin = text.begin();
  return {
      {idFile, 1 + static_cast<int>(std::count(begin, begin + static_cast<std::ptrdiff_t>(id), '\n')),
       "local_size_x_id",
       "a scene does not set the size of groups; write it here, such as layout(local_size_x = 64) in;"}};
}

std::vector<Mistake> beyondLimits(const Module& module, const Files& files, const std::string& entry,
                                  int line) {
  std::vector<Mistake> mistakes;
  for (const Instruction& one : module.head)
    if (one.op == SpvOpExecutionMode && one.operands[1] == SpvExecutionModeLocalSize)
      mistakes = beyondThreads(one, attributeOf(files, entry, line));
  for (const auto* section : {&module.globals, &module.body})
    for (const Instruction& one : *section) {
      if (one.op != SpvOpVariable ||
          (one.operands[0] != SpvStorageClassFunction && one.operands[0] != SpvStorageClassPrivate))
        continue;
      const std::uint64_t bytes = bytesOf(module, module.global(one.type)->operands[1]);
      if (bytes <= maxPrivate) continue;
      const std::string name = module.name(one.result);
      mistakes.push_back(said(at(files, name, {}, line),
                              fmt::format("{} takes more than {} bytes in each invocation; use a buffer",
                                          scene::inQuotes(name), maxPrivate)));
    }
  return mistakes;
}

std::vector<Mistake> beyondShared(const Module& module, const Files& files, int line) {
  std::uint64_t bytes = 0, largest = 0;
  std::string name;
  for (const Instruction& one : module.globals) {
    if (one.op != SpvOpVariable || one.operands[0] != SpvStorageClassWorkgroup) continue;
    const std::uint64_t own = bytesOf(module, module.global(one.type)->operands[1]);
    bytes += own;
    if (own <= largest) continue;
    largest = own;
    name = module.name(one.result);
  }
  if (bytes <= maxShared) return {};
  return {said(at(files, name, {"groupshared", "shared"}, line),
               fmt::format("the groups share {} bytes; OpenGL grants {}", bytes, maxShared))};
}

}  // namespace simreel::kernels

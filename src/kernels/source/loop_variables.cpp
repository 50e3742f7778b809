#include "kernels/source/loop_variables.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace simreel::kernels {

Edits declaredBeforeLoop(const Scan& scan, std::string_view name, int line) {
  std::size_t place = 0;
  for (int i = 1; i < line && place < scan.code.size(); ++i)
    place = std::min(scan.code.find('\n', place), scan.code.size() - 1) + 1;
  Edits edits;
  for (std::size_t i = scan.all.size(); i-- > 1;) {
    if (scan.all[i].text != "for" || scan.all[i].at >= place || i + 4 >= scan.all.size()) continue;
    if (scan.all[i].depth == 0) break;
    const std::size_t type = i + 2;
    std::size_t close = type;
    while (close < scan.all.size() && scan.all[close].text != ";") ++close;
    std::string names;
    bool found = false;
    for (const auto& [begin, end] : parts(scan.all, type + 1, close)) {
      names += (names.empty() ? "" : ", ") + std::string(scan.all[begin].text);
      found = found || scan.all[begin].text == name;
    }
    const std::string_view before = scan.all[i - 1].text;
    const bool stands = before == ";" || before == "{" || before == "}";
    if (!found || !stands || !numeric(scan.all[type].text) || !scan.all[type + 1].isWord()) continue;
    edits.insert(scan.all[i].at, fmt::format("{} {}; ", scan.all[type].text, names));
    edits.replace(scan.all[type].at, scan.all[type].end(), "");
    return edits;
  }
  return edits;
}

}  // namespace simreel::kernels

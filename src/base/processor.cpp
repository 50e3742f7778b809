#include "base/processor.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <sched.h>
#include <sys/utsname.h>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace simreel {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0)
    text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
  return text;
}

/// Returns the text after "key   : ", or an empty text if the key does not occur.
std::string_view valueOf(std::string_view text, std::string_view key) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t colon = line.find(':');
    if (colon != std::string_view::npos && trimmed(line.substr(0, colon)) == key)
      return trimmed(line.substr(colon + 1));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  return {};
}

bool hasWord(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const std::string_view first = words.substr(0, words.find(' '));
    if (first == word) return true;
    words.remove_prefix(std::min(words.size(), first.size() + 1));
  }
  return false;
}

}  // namespace

std::string processorName(std::string_view cpuinfo, const std::string& architecture) {
  std::string name(valueOf(cpuinfo, "model name"));
  const auto addNumbers = [&](auto... keys) {
    std::string numbers;
    for (const auto& [word, key] : {keys...})
      if (const std::string_view value = valueOf(cpuinfo, key); !value.empty())
        numbers += fmt::format("{}{} {}", numbers.empty() ? "" : " ", word, value);
    if (!numbers.empty()) name += (name.empty() ? "" : ", ") + numbers;
  };
  using Number = std::pair<const char*, const char*>;
  addNumbers(Number("family", "cpu family"), Number("model", "model"), Number("stepping", "stepping"));
  addNumbers(Number("implementer", "CPU implementer"), Number("part", "CPU part"),
             Number("variant", "CPU variant"), Number("revision", "CPU revision"));
  std::string sets;
  for (const char* set : {"sse4_1", "avx", "f16c", "fma", "avx2", "avx512f", "sve"})
    if (hasWord(valueOf(cpuinfo, "flags"), set) || hasWord(valueOf(cpuinfo, "Features"), set))
      sets += fmt::format("{}{}", sets.empty() ? "" : " ", set);
  if (name.empty()) return "unknown " + architecture;
  return sets.empty() ? name : name + ", " + sets;
}

std::string processorName() {
  std::ifstream file("/proc/cpuinfo");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  utsname system{};
  const bool known = uname(&system) == 0;
  return processorName(text, known ? system.machine : "processor");
}

std::size_t processorCount() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  const std::size_t count = ::sched_getaffinity(0, sizeof allowed, &allowed) == 0
                                ? static_cast<std::size_t>(CPU_COUNT(&allowed))
                                : std::thread::hardware_concurrency();
  return std::max<std::size_t>(1, count);
}

}  // namespace simreel

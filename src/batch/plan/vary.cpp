#include "batch/plan/vary.hpp"

#include "base/error.hpp"

#include <charconv>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>

namespace simreel::batch {

namespace {

constexpr const char* forms =
    "write path=a,b,c or path=first:last:step, for example render.samples=1,4,16 or objects.dish."
    "grayScott.feed=0.02:0.06:0.01";

std::optional<double> numberOf(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// Splits text at each separator that is outside brackets and quotes.
std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') quoted = !quoted;
    if (quoted && c == '\\' && i + 1 < text.size()) {
      parts.back() += text.substr(i++, 2);
      continue;
    }
    if (!quoted) depth += (c == '[' || c == '{' ? 1 : 0) - (c == ']' || c == '}' ? 1 : 0);
    if (c == separator && depth == 0 && !quoted)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

/// Returns the numbers of a range such as "0:1:0.1". Returns an empty list if a part is not a number.
std::vector<double> rangeOf(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : split(text, ':')) {
    const auto number = numberOf(part);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

/// Appends the values from first to last in steps. Includes the last value if the distance is a whole
/// number of steps. Writes twelve digits to hide rounding errors, so that three steps of 0.1 give 0.3.
void addSteps(const std::string& text, const std::vector<double>& range, std::vector<std::string>& values) {
  const double first = range[0], last = range[1], step = range[2];
  const double count = step == 0 ? -1 : std::floor((last - first) / step + 1e-9);
  if (count < 0)
    fail(ExitCode::usage, "--vary {}: a step of {:g} does not lead from {:g} to {:g}", text, step, first,
         last);
  if (count >= static_cast<double>(maxJobs))
    fail(ExitCode::usage, "--vary {}: more than {} values", text, maxJobs);
  for (int i = 0; i <= static_cast<int>(count); ++i)
    values.push_back(fmt::format("{:.12g}", first + i * step));
}

/// Returns an evenly distributed hash of two numbers (splitmix64).
std::uint64_t mixed(std::uint64_t seed, std::uint64_t counter) {
  std::uint64_t z = seed * 0x9E3779B97F4A7C15U + (counter + 1) * 0xD1B54A32D192ED03U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

/// Returns the value of a parameter for each sample.
std::vector<std::string> drawn(const Vary& varied, std::size_t samples, std::uint64_t seed) {
  std::vector<std::size_t> order(samples);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = samples; i > 1; --i) std::swap(order[i - 1], order[mixed(seed, i) % i]);
  std::vector<std::string> values;
  values.reserve(samples);
  for (const std::size_t part : order) {
    if (!varied.isRange()) {
      values.push_back(varied.values[part % varied.values.size()]);
      continue;
    }
    const double within = static_cast<double>(mixed(seed, samples + 1 + part) >> 11U) * 0x1p-53;
    const double place = (static_cast<double>(part) + within) / static_cast<double>(samples);
    values.push_back(fmt::format("{:.6g}", varied.low + (varied.high - varied.low) * place));
  }
  return values;
}

void checkRanges(const std::vector<Vary>& varied) {
  for (const Vary& one : varied)
    if (one.isRange())
      fail(ExitCode::usage,
           "--vary {}={:g}:{:g} has no step; write low:high:step, or add --sample N for random values",
           one.path, one.low, one.high);
}

std::size_t gridSize(const std::vector<Vary>& varied) {
  std::size_t count = 1;
  for (const Vary& one : varied) {
    count *= one.values.size();
    if (count > maxJobs) fail(ExitCode::usage, "--vary: more than {} jobs", maxJobs);
  }
  return count;
}

}  // namespace

Vary parseVary(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    fail(ExitCode::usage, "--vary {}: {}", text, forms);
  Vary result;
  result.path = text.substr(0, equals);
  const std::vector<std::string> parts = split(text.substr(equals + 1), ',');
  for (const std::string& part : parts) {
    if (part.empty()) fail(ExitCode::usage, "--vary {}: a value is missing; {}", text, forms);
    const std::vector<double> range = rangeOf(part);
    if (range.size() == 3) {
      addSteps(text, range, result.values);
    } else if (range.size() == 2) {
      if (parts.size() > 1 || !(range[0] < range[1]))
        fail(ExitCode::usage, "--vary {}: a random range must be low:high, without other values", text);
      result.low = range[0];
      result.high = range[1];
    } else {
      result.values.push_back(part);
    }
  }
  std::map<std::string, std::string> seen;  // Numbers are compared by value: 0.50 equals 0.5.
  for (const std::string& value : result.values) {
    const auto number = numberOf(value);
    const auto [first, isNew] = seen.emplace(number ? fmt::format("{}", *number) : value, value);
    if (!isNew)
      fail(ExitCode::usage, "--vary {}: {} occurs twice{}", text, value,
           first->second == value ? "" : fmt::format(", also as {}", first->second));
  }
  return result;
}

std::vector<std::vector<scene::Override>> combine(const std::vector<Vary>& varied, Combination how,
                                                  std::size_t samples, std::uint64_t seed) {
  std::set<std::string> paths;
  for (const Vary& one : varied)
    if (!paths.insert(one.path).second)
      fail(ExitCode::usage, "--vary {} is given twice; list all its values in one --vary", one.path);
  std::size_t count = samples;
  if (how == Combination::grid) {
    checkRanges(varied);
    count = gridSize(varied);
  }
  if (how == Combination::zip) {
    checkRanges(varied);
    count = varied.front().values.size();
    for (const Vary& one : varied)
      if (one.values.size() != count)
        fail(ExitCode::usage,
             "--zip: {} has {} values and {} has {}; give all parameters the same number of values",
             varied.front().path, count, one.path, one.values.size());
  }
  if (count == 0 || count > maxJobs)
    fail(ExitCode::usage, "a sweep has from 1 to {} jobs, not {}", maxJobs, count);

  std::vector<std::vector<scene::Override>> jobs(count);
  std::size_t repeats = count;  // number of successive jobs of a grid that have the same value
  for (std::size_t v = 0; v < varied.size(); ++v) {
    const Vary& one = varied[v];
    std::vector<std::string> values;
    if (how == Combination::sample) values = drawn(one, samples, mixed(seed, v));
    if (how == Combination::grid) repeats /= one.values.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::string& value = how == Combination::sample ? values[i]
                                 : how == Combination::zip  ? one.values[i]
                                                            : one.values[i / repeats % one.values.size()];
      jobs[i].push_back({one.path, value});
    }
  }
  return jobs;
}

}  // namespace simreel::batch

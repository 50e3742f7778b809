#include "scene/help.hpp"

#include "scene/default_text.hpp"
#include "scene/value_writer.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::scene {

namespace {

/// "0..1", ">= 0", "> 0", "<= 3"; "any" without bounds that matter.
std::string shortRange(Range range) {
  const bool below = range.least > anyNumber.least, above = range.most < anyNumber.most;
  const std::string most = above ? fmt::format("{}", range.most) : "";
  if (range.least == positive.least) return above ? "> 0, <= " + most : "> 0";
  if (below && above) return fmt::format("{}..{}", range.least, most);
  if (below) return fmt::format(">= {}", range.least);
  return above ? "<= " + most : "any";
}

std::string moving(const char* doc) {
  return fmt::format("{} May move along keyframes.", doc);
}

template <class T>
std::string written(const T& value) {
  return shortest(value).dump();
}

}  // namespace

void HelpWriter::add(const std::string& name, std::string standard, std::string range, const char* unit,
                     std::string doc) {
  rows_.push_back({prefix_ + name, std::move(standard), std::move(range), unit, std::move(doc)});
}

std::string HelpWriter::table() const {
  std::vector<Row> rows = {{"name", "default", "range", "unit", "meaning"}};
  rows.insert(rows.end(), rows_.begin(), rows_.end());
  const auto width = [&](std::string Row::*column) {
    std::size_t most = 0;
    for (const Row& row : rows) most = std::max(most, (row.*column).size());
    return most;
  };
  const std::size_t name = width(&Row::name), standard = width(&Row::standard);
  const std::size_t range = width(&Row::range), unit = width(&Row::unit);
  std::string out;
  for (const Row& row : rows)
    out += fmt::format("  {:<{}}  {:<{}}  {:<{}}  {:<{}}  {}\n", row.name, name, row.standard, standard,
                       row.range, range, row.unit, unit, row.doc);
  return out;
}

void HelpWriter::boolean(const char* name, bool& value, const char* doc) {
  add(name, value ? "true" : "false", "true, false", "", doc);
}

void HelpWriter::integer(const char* name, int& value, Range range, const char* unit, const char* doc) {
  add(name, written(value), shortRange(range), unit, doc);
}

void HelpWriter::number(const char* name, float& value, Range range, const char* unit, const char* doc) {
  add(name, written(value), shortRange(range), unit, doc);
}

void HelpWriter::number(const char* name, double& value, Range range, const char* unit, const char* doc) {
  add(name, written(value), shortRange(range), unit, doc);
}

void HelpWriter::number(const char* name, Animated<float>& value, Range range, const char* unit,
                        const char* doc) {
  add(name, written(value), shortRange(range), unit, moving(doc));
}

void HelpWriter::optionalNumber(const char* name, std::optional<double>& /*value*/, Range range,
                                const char* unit, const char* doc) {
  add(name, "off", shortRange(range), unit, doc);
}

void HelpWriter::vector(const char* name, glm::vec3& value, Range range, const char* unit,
                        const char* doc) {
  add(name, written(value), shortRange(range), unit, doc);
}

void HelpWriter::vector(const char* name, Animated<glm::vec3>& value, Range range, const char* unit,
                        const char* doc) {
  add(name, written(value), shortRange(range), unit, moving(doc));
}

void HelpWriter::pair(const char* name, glm::ivec2& value, Range range, const char* unit, const char* doc) {
  add(name, written(value), shortRange(range), unit, doc);
}

void HelpWriter::pairs(const char* name, std::vector<glm::ivec2>& value, Range range, const char* unit,
                       const char* doc) {
  nlohmann::ordered_json standard = nlohmann::ordered_json::array();
  for (const glm::ivec2& item : value) standard.push_back(shortest(item));
  add(name, standard.dump(), shortRange(range), unit, doc);
}

void HelpWriter::text(const char* name, std::string& value, const char* doc) {
  add(name, nlohmann::ordered_json(value).dump(), "text", "", doc);
}

void HelpWriter::integerOr(const char* name, std::optional<int>& value, const char* word, Range range,
                           const char* unit, const char* doc) {
  const std::string quotedWord = fmt::format("\"{}\"", word);
  add(name, value ? written(*value) : quotedWord, fmt::format("{} or {}", shortRange(range), quotedWord),
      unit, doc);
}

void HelpWriter::integers(const char* name, std::vector<int>& value, Range range, const char* unit,
                          const char* doc) {
  add(name, nlohmann::ordered_json(value).dump(), shortRange(range), unit, doc);
}

void HelpWriter::oneOf(const char* name, int& value, const std::vector<const char*>& names,
                       const char* doc) {
  add(name, value < 0 ? "off" : fmt::format("\"{}\"", names[static_cast<std::size_t>(value)]),
      fmt::format("{}", fmt::join(names, ", ")), "", doc);
}

void HelpWriter::someOf(const char* name, std::vector<int>& value, const std::vector<const char*>& names,
                        const char* doc) {
  nlohmann::ordered_json standard = nlohmann::ordered_json::array();
  for (const int index : value) standard.push_back(names[static_cast<std::size_t>(index)]);
  add(name, standard.dump(), fmt::format("some of {}", fmt::join(names, ", ")), "", doc);
}

void HelpWriter::asset(const char* name, std::filesystem::path& value, const char* doc) {
  add(name, nlohmann::ordered_json(value.string()).dump(), "file", "", doc);
}

void HelpWriter::addGroup(const char* name, const char* doc, const char* standard,
                          const std::function<void(Fields&)>& describe) {
  add(name, standard, "", "", doc);
  if (!expandGroups_) return;
  const std::string outer = prefix_;
  prefix_ += std::string(name) + ".";
  describe(*this);
  prefix_ = outer;
}

void HelpWriter::group(const char* name, const char* doc, const std::function<void(Fields&)>& describe) {
  addGroup(name, doc, "", describe);
}

void HelpWriter::optionalGroup(const char* name, bool& /*present*/, const char* doc,
                               const std::function<void(Fields&)>& describe) {
  addGroup(name, doc, "off", describe);
}

void HelpWriter::leftOut(const char* name, const char* what) {
  for (Row& row : rows_)
    if (row.name == prefix_ + name) row.standard = what;
}

void HelpWriter::listOf(const char* name, const char* doc, std::size_t mostItems, std::size_t items,
                        const std::function<void(std::size_t)>& resize,
                        const std::function<void(Fields&, std::size_t)>& describe) {
  const nlohmann::ordered_json standard = standardItems(items, resize, describe);
  constexpr std::size_t widest = 30;  // the schema has longer ones
  const std::string text = standard.dump();
  add(name, text.size() <= widest ? text : fmt::format("{} items", standard.size()),
      fmt::format("up to {}", mostItems), "", doc);
  if (!expandGroups_) return;
  const std::string outer = prefix_;
  prefix_ += std::string(name) + "[].";
  describe(*this, 0);
  prefix_ = outer;
}

}  // namespace simreel::scene

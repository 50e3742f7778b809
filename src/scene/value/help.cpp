#include "scene/value/help.hpp"

#include "scene/value/value_writer.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::scene {

namespace {

/// Returns the range as "0..1", ">= 0", "> 0" or "<= 3". Returns "any" if the range has no meaningful
/// bound.
std::string shortRange(Range range) {
  const bool below = range.min > anyNumber.min, above = range.max < anyNumber.max;
  const std::string max = above ? fmt::format("{}", range.max) : "";
  if (range.min == positive.min) return above ? "> 0, <= " + max : "> 0";
  if (below && above) return fmt::format("{}..{}", range.min, max);
  if (below) return fmt::format(">= {}", range.min);
  return above ? "<= " + max : "any";
}

/// Returns the allowed values of a field in words.
std::string rangeOf(const Member& member, const Spec& spec) {
  if (std::holds_alternative<bool*>(member)) return "true, false";
  if (std::holds_alternative<std::string*>(member)) return "text";
  if (std::holds_alternative<std::filesystem::path*>(member)) return "file";
  if (std::holds_alternative<Formula*>(member)) return "numbers, expressions";
  if (std::holds_alternative<Formulas*>(member)) return "numbers, expressions, by name";
  const bool several = std::holds_alternative<std::vector<int>*>(member);
  if (!spec.words.empty())
    return fmt::format("{}{}", several ? "some of " : "", fmt::join(spec.words, ", "));
  const std::string range = shortRange(spec.range);
  return spec.none == nullptr ? range : fmt::format("{} or \"{}\"", range, spec.none);
}

bool mayMove(const Member& member) {
  return std::holds_alternative<Animated<float>*>(member) ||
         std::holds_alternative<Animated<glm::vec3>*>(member) || std::holds_alternative<Formula*>(member);
}

}  // namespace

std::string HelpRow::facts() const {
  std::string text;
  const auto say = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  if (!standard.empty() && standard != "\"\"") say("default " + standard);
  if (!range.empty()) say(range);
  if (!unit.empty()) say(unit);
  return text;
}

void HelpWriter::add(const std::string& name, std::string standard, std::string range, const char* unit,
                     std::string doc) {
  rows_.push_back({prefix_ + name, std::move(standard), std::move(range), unit, std::move(doc), false});
}

void HelpWriter::field(const char* name, Member member, const Spec& spec) {
  const auto standard = written(member, spec);
  add(name, standard ? standard->dump() : "off", rangeOf(member, spec), spec.unit,
      fmt::format("{}{}{}", spec.doc, spec.color ? " Or \"#rrggbb\", or a colour's name." : "",
                  mayMove(member) ? " May move along keyframes." : ""));
}

void HelpWriter::section(const char* name, bool* present, const char* doc,
                         const std::function<void(Fields&)>& describe) {
  const auto word = shorthands_.find(name);
  const bool isShort = word != shorthands_.end();
  const auto number = shortNumbers_.find(name);
  add(name, present == nullptr ? "" : "off", "", "",
      isShort                         ? fmt::format("{} A word alone is its \"{}\".", doc, word->second)
      : number != shortNumbers_.end() ? fmt::format("{} A number alone is its \"{}\".", doc, number->second)
      : switchable_.contains(name)    ? fmt::format("{} Or true: all as by default.", doc)
                                      : doc);
  rows_.back().group = true;
  if (!expandGroups_) return;
  const std::string outer = prefix_;
  prefix_ += std::string(name) + ".";
  describe(*this);
  prefix_ = outer;
}

void HelpWriter::leftOut(const char* name, const char* what) {
  for (HelpRow& row : rows_)
    if (row.name == prefix_ + name) row.standard = what;
}

void HelpWriter::listOf(const char* name, const char* doc, std::size_t maxItems, std::size_t items,
                        const std::function<void(std::size_t)>& resize,
                        const std::function<void(Fields&, std::size_t)>& describe) {
  const nlohmann::ordered_json standard = standardItems(items, resize, describe);
  // Max number of characters of a default in the table. Longer defaults appear only in the schema.
  constexpr std::size_t widest = 30;
  const std::string text = standard.dump();
  const auto value = shorthands_.find(name);
  add(name, text.size() <= widest ? text : fmt::format("{} items", standard.size()),
      fmt::format("up to {}", maxItems), "",
      value == shorthands_.end() ? doc
                                 : fmt::format("{} A value alone is its \"{}\".", doc, value->second));
  rows_.back().group = true;
  if (!expandGroups_) return;
  const std::string outer = prefix_;
  prefix_ += std::string(name) + "[].";
  describe(*this, 0);
  prefix_ = outer;
}

void HelpWriter::namedGroups(const char* name, const char* doc, const char* one, std::size_t maxItems,
                             const std::vector<std::string>& names,
                             const std::function<void(const std::vector<std::string>&)>& rename,
                             const std::function<void(Fields&, std::size_t)>& describe) {
  const auto value = shorthands_.find(name);
  add(name, "{}", fmt::format("up to {}", maxItems), "",
      value == shorthands_.end() ? doc
                                 : fmt::format("{} A value alone is its \"{}\".", doc, value->second));
  rows_.back().group = true;
  if (!expandGroups_) return;
  const std::string outer = prefix_;
  prefix_ += fmt::format("{}.{}.", name, one);
  rename({one});
  describe(*this, 0);
  rename(names);
  prefix_ = outer;
}

}  // namespace simreel::scene

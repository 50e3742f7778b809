#include "sim/automata/rule/cell_rule.hpp"

#include "base/text.hpp"
#include "sim/automata/rule/notation.hpp"
#include "sim/automata/rule/signal_rules.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

std::string lowerText(std::string_view text) {
  std::string low(text);
  std::transform(low.begin(), low.end(), low.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return low;
}

/// Returns only the letters and digits of a text, in lower case, so that "Brian's Brain" and "brians-brain"
/// match.
std::string bareName(std::string_view text) {
  std::string bare = lowerText(text);
  std::erase_if(bare, [](char c) { return !isDigit(c) && (c < 'a' || c > 'z'); });
  return bare;
}

/// Returns the description ("a rule of ...") of a rule that other programs support but this one does not;
/// null for other texts. Such notations are listed in Golly's help and in the LifeWiki.
const char* otherKind(std::string_view text) {
  const std::string low = lowerText(text);
  if ((low.size() > 1 && low[0] == 'm' && isDigit(low[1])) || low.starts_with("margolus"))
    return "a rule of blocks (Margolus)";
  if ((low[0] == 'b' || low[0] == 's' || isDigit(low[0])) && low.back() == 'l' &&
      low.find('/') != std::string::npos)
    return "a rule of triangles";
  return nullptr;
}

/// Sets a rule of signals by its name or by a former name from Golly. Returns false for other texts.
bool setSignalRule(std::string_view text, CellRule& rule) {
  struct Name {
    const char *bare, *name;
    SignalRule rule;
  };
  constexpr std::array<Name, 5> names = {{{"jvn29", "JvN29", SignalRule::jvn29},
                                          {"nobili32", "Nobili32", SignalRule::nobili32},
                                          {"jvn32", "Nobili32", SignalRule::nobili32},
                                          {"hutton32", "Hutton32", SignalRule::hutton32},
                                          {"modjvn32", "Hutton32", SignalRule::hutton32}}};
  const std::string bare = bareName(text);
  for (const Name& name : names) {
    if (bare != name.bare) continue;
    rule = {};
    rule.family = CellRule::Family::tree;
    rule.states = statesOf(name.rule);
    rule.tree = signalTree(name.rule);
    rule.colors = signalColors(name.rule);
    rule.name = name.name;
    return true;
  }
  return false;
}

RuleProblem parseAnyNotation(std::string_view text, const std::string& low, CellRule& rule) {
  if (setSignalRule(text, rule)) return {};
  const bool digit = isDigit(low[0]);
  if (low.starts_with("map")) return parseMap(text, rule);
  if (low.size() > 1 && low[0] == 'w' && isDigit(low[1])) return parseWolfram(text, rule);
  if (low.size() > 1 && low[0] == 'r' && isDigit(low[1]))
    return low.find(',') != std::string::npos ? parseWide(text, rule) : parseCyclic(text, rule);
  if (digit && low.find(',') != std::string::npos) return parseWide(text, rule);
  return parseCounts(text, rule);
}

}  // namespace

const std::vector<RulePreset>& rulePresets() {
  static const std::vector<RulePreset> list = {
      {"Life", "B3/S23", "Conway 1970"},
      {"HighLife", "B36/S23", "with a replicator (Bell 1994)"},
      {"Day & Night", "B3678/S34678", "the living and the dead behave alike (Thompson 1997)"},
      {"Seeds", "B2/S", "nothing survives, and most explodes (Silverman)"},
      {"Just Friends", "B2-a/S12", "two neighbours that do not touch give birth (Bell)"},
      {"Brian's Brain", "/2/3", "cells fire, rest, and are ready again (Silverman 1984)"},
      {"Star Wars", "345/2/4", "Generations of four states (Wojtowicz 1999)"},
      {"Frogs", "12/34/3", "Generations of three states (Ladd)"},
      {"Fireworks", "2/13/21", "Generations of 21 states (Elliott)"},
      {"Bosco", "R5,C0,M1,S34..58,B34..45,NM", "bugs of range 5 (Evans 1996)"},
      {"Bugsmovie", "R10,C0,M1,S123..212,B123..170,NM", "bugs of range 10 (Griffeath)"},
      {"Majority", "R4,C0,M1,S41..81,B41..81,NM", "each does as most around it (Griffeath)"},
      {"Waffle", "R7,C0,M1,S100..200,B75..170,NM", "Evans"},
      {"Cyclic", "R1/T1/C14/NN", "spirals of fourteen states (Griffeath 1988)"},
      {"313", "R1/T3/C3/NM", "cyclic, three states: turbulent spirals (Griffeath)"},
      {"Cubism", "R2/T5/C3/NN", "cyclic: blocks that meet (Griffeath)"},
      {"JvN29", "JvN29", "self-reproducing machines of 29 states (von Neumann 1966)"},
      {"Nobili32", "Nobili32", "JvN29 with signals that cross (Nobili 1996)"},
      {"Hutton32", "Hutton32", "JvN29 with wires that are retracted (Hutton 2008)"},
  };
  return list;
}

std::string LifeRule::text() const {
  std::string result = "B";
  for (int n = 0; n <= 8; ++n)
    if ((born >> n & 1) != 0) result += static_cast<char>('0' + n);
  result += "/S";
  for (int n = 0; n <= 8; ++n)
    if ((survives >> n & 1) != 0) result += static_cast<char>('0' + n);
  return result;
}

int CellRule::range() const {
  return family == Family::wide ? wide.range : family == Family::cyclic ? cyclic.range : 1;
}

bool CellRule::outcome(unsigned neighbourhood) const {
  constexpr unsigned middle = 1U << 4;
  if (family == Family::map) return (map[neighbourhood / 32] >> (neighbourhood % 32) & 1U) != 0;
  const int mask = (neighbourhood & middle) != 0 ? counts.survives : counts.born;
  return (mask >> std::popcount(neighbourhood & ~middle) & 1) != 0;
}

std::string shownCharacter(std::string_view text, std::size_t at) {
  if (at >= text.size()) return "the end";
  const char c = text[at];
  return fmt::format("'{}'", c >= ' ' && c <= '~' ? c : '?');
}

RuleProblem takeRuleNumber(std::string_view text, std::size_t& at, const char* what, int min, int max,
                           int& value) {
  const std::size_t start = at;
  long read = 0;
  for (; at < text.size() && isDigit(text[at]); ++at)
    read = std::min(read * 10 + (text[at] - '0'), 1'000'000L);
  if (at == start)
    return {at, fmt::format("{} is missing: a number is expected {}", what,
                            at < text.size() ? "here" : "at the end")};
  if (read < min || read > max)
    return {start, fmt::format("{} is {} here; it goes from {} to {}", what, read, min, max)};
  value = static_cast<int>(read);
  return {};
}

bool isRuleName(std::string_view text) {
  const std::string low = lowerText(text);
  if (low.empty() || low[0] < 'a' || low[0] > 'z' || otherKind(text) != nullptr) return false;
  if (low.size() > 1 && (low[0] == 'b' || low[0] == 's' || low[0] == 'r' || low[0] == 'w') &&
      isDigit(low[1]))
    return false;
  return std::all_of(low.begin(), low.end(),
                     [](char c) {
                       return isDigit(c) || (c >= 'a' && c <= 'z') || c == '-' || c == '_' || c == '+' ||
                              c == '.';
                     }) &&
         !low.starts_with("map");
}

RuleProblem parseCellRule(std::string_view text, CellRule& rule) {
  if (text.empty())
    return {0, "the rule is empty; write a rule as \"B3/S23\" (or \"23/3\", survival first)"};
  const std::string low = lowerText(text), bare = bareName(text);
  // Notations such as "23/3" are skipped, because without punctuation, "313" would match a preset.
  if (text.find('/') == std::string_view::npos || text.find(' ') != std::string_view::npos)
    for (const RulePreset& preset : rulePresets())
      if (bare == bareName(preset.name)) {
        text = preset.rule;
        return parseAnyNotation(text, lowerText(text), rule);
      }
  RuleProblem problem = parseAnyNotation(text, low, rule);
  if (problem.message.empty()) return problem;
  if (const std::size_t colon = text.find(':'); colon != std::string_view::npos && colon > 0)
    if (CellRule before; parseCellRule(text.substr(0, colon), before).message.empty())
      return {colon,
              "a rule in a scene cannot name a grid; use \"size\" and \"border\", or a pattern's file"};
  const bool letter = low[0] >= 'a' && low[0] <= 'z';
  if (const char* kind = otherKind(text))
    problem.message = fmt::format("this is {}, which is not supported", kind);
  else if (letter && low[0] != 'b' && low[0] != 's' && low[0] != 'r' && !low.starts_with("map") &&
           !(low[0] == 'w' && low.size() > 1 && isDigit(low[1])))
    problem = {0,
               "this rule is unknown: neither a notation nor a name that `simreel list life` prints; give "
               "a .rule file as \"ruleFile\""};
  return problem;
}

}  // namespace simreel::sim

#include "sim/automata/file/rule_table.hpp"

#include "base/text.hpp"
#include "sim/automata/file/rule_tree.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr std::size_t maxTransitions = 200'000;

using States = std::bitset<256>;

std::string lowWord(std::string_view text) {
  std::string low(text);
  std::transform(low.begin(), low.end(), low.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return low;
}

/// Returns the permutations of n neighbours that belong to a symmetry. A permutation lists the new index of
/// each neighbour. The list is empty for an unknown symmetry; "permute" is handled separately.
std::vector<std::vector<int>> permutations(const std::string& symmetry, int n) {
  const auto turned = [&](int steps, bool reflected) {
    std::vector<int> result(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
      const int at = reflected ? (n - i) % n : i;
      result[static_cast<std::size_t>(i)] = (at + steps) % n;
    }
    return result;
  };
  if (symmetry == "none") return {turned(0, false)};
  if (n == 2)
    return symmetry == "reflect" ? std::vector{turned(0, false), turned(1, false)}
                                 : std::vector<std::vector<int>>{};
  if (symmetry == "reflect_horizontal" && n != 6) return {turned(0, false), turned(0, true)};
  std::string_view name = symmetry;
  const bool reflected = name.ends_with("reflect");
  if (reflected) name.remove_suffix(7);
  if (!name.starts_with("rotate") || name.size() != 7) return {};
  const int turns = name[6] - '0';
  const bool known = n == 6 ? turns == 2 || turns == 3 || turns == 6 : turns == 4 || (turns == 8 && n == 8);
  if (!known || (reflected && n == 6 && turns != 6)) return {};
  std::vector<std::vector<int>> result;
  for (int i = 0; i < turns; ++i) {
    result.push_back(turned(i * n / turns, false));
    if (reflected) result.push_back(turned(i * n / turns, true));
  }
  return result;
}

class TableReader {
 public:
  explicit TableReader(const RuleFileText& file) : file_(file), lines_(file.section("@TABLE")) {}

  CellRule read() {
    for (const RuleFileText::Line& line : lines_) {
      if (line.text.find(':') != std::string_view::npos)
        header(line);
      else if (line.text.starts_with("var ") || line.text.starts_with("var\t"))
        variable(line);
      else
        transition(line);
    }
    if (states_ == 0) file_.wrong("@TABLE lacks \"n_states:\"; the file may be cut off");
    CellRule rule;
    rule.family = CellRule::Family::tree;
    rule.states = states_;
    rule.tree = treeOf(table_, shape_, states_);
    if (!rule.tree)
      file_.wrong(fmt::format("its table is too complex: its decision diagram has more than {} items",
                              maxTreeItems));
    return rule;
  }

 private:
  void header(const RuleFileText::Line& line) {
    const std::size_t colon = line.text.find(':');
    const std::string key = lowWord(line.text.substr(0, colon));
    const RuleWord value = wordsOf(line.text.substr(colon + 1), false).empty()
                               ? RuleWord{0, ""}
                               : wordsOf(line.text.substr(colon + 1), false)[0];
    const std::size_t at = colon + 1 + value.at;
    if (!table_.empty()) file_.wrong(line, 0, "this must come before the first transition");
    if (!variables_.empty() && key == "n_states")
      file_.wrong(line, 0,
                  "this must come before the first variable, because it sets the number of states");
    if (key == "n_states") {
      states_ = file_.number(line, at, value.text, 256, "the number of states");
      if (states_ < 2) file_.wrong(line, at, "a rule has at least 2 states");
    } else if (key == "neighborhood") {
      const std::string name = lowWord(value.text);
      static const std::map<std::string, TableShape> shapes = {
          {"vonneumann", TableShape::vonNeumann},
          {"moore", TableShape::moore},
          {"hexagonal", TableShape::hexagonal},
          {"onedimensional", TableShape::oneDimensional}};
      const auto found = shapes.find(name);
      if (found == shapes.end())
        file_.wrong(
            line, at,
            fmt::format(
                "the neighbourhood \"{}\" is unknown; use vonNeumann, Moore, hexagonal or oneDimensional",
                value.text));
      shape_ = found->second;
    } else if (key == "symmetries") {
      symmetry_ = lowWord(value.text);
      symmetryLine_ = line;
      symmetryAt_ = at;
    } else {
      file_.wrong(line, 0,
                  fmt::format("\"{}\" is unknown; known here: n_states, neighborhood, symmetries", key));
    }
  }

  void needStates(const RuleFileText::Line& line) const {
    if (states_ == 0) file_.wrong(line, 0, "\"n_states:\" must come before this");
  }

  /// Returns the states that a word stands for: a number or a variable.
  States statesOf(const RuleFileText::Line& line, const RuleWord& word) const {
    if (const auto found = variables_.find(word.text); found != variables_.end()) return found->second;
    if (word.text.empty()) file_.wrong(line, word.at, "a state is missing here");
    if (!isDigit(word.text[0]))
      file_.wrong(
          line, word.at,
          fmt::format("\"{}\" is neither a state nor a variable that is declared before", word.text));
    States states;
    states.set(static_cast<std::size_t>(file_.number(line, word.at, word.text, states_ - 1, "a state")));
    return states;
  }

  void variable(const RuleFileText::Line& line) {
    needStates(line);
    const std::size_t equals = line.text.find('=');
    std::size_t open = line.text.find('{'), close = line.text.find('}');
    if (open == std::string_view::npos && close == std::string_view::npos &&
        line.text.find(',') == std::string_view::npos) {
      open = equals;  // the value of a variable may be another variable, as in "var b=a"
      close = line.text.size();
    }
    if (equals == std::string_view::npos || open == std::string_view::npos ||
        close == std::string_view::npos || open < equals || close < open)
      file_.wrong(line, 0, "a variable is written as \"var a={1,2,3}\" or \"var b=a\"");
    const auto name = wordsOf(line.text.substr(4, equals - 4), false);
    if (name.size() != 1 || isDigit(name[0].text[0]))
      file_.wrong(line, 4, "the name of a variable is one word that begins with a letter");
    States states;
    for (RuleWord word : wordsOf(line.text.substr(open + 1, close - open - 1), true)) {
      word.at += open + 1;
      states |= statesOf(line, word);
    }
    variables_[std::string(name[0].text)] = states;
  }

  std::vector<RuleWord> wordsIn(const RuleFileText::Line& line) const {
    if (line.text.find(',') != std::string_view::npos) return wordsOf(line.text, true);
    // In a line without commas, each digit is a state.
    std::vector<RuleWord> words;
    for (std::size_t i = 0; i < line.text.size(); ++i)
      if (line.text[i] != ' ' && line.text[i] != '\t') words.push_back({i, line.text.substr(i, 1)});
    return words;
  }

  void transition(const RuleFileText::Line& line) {
    needStates(line);
    const int n = neighboursOf(shape_);
    const std::vector<RuleWord> words = wordsIn(line);
    const auto count = static_cast<std::size_t>(n) + 2;
    if (words.size() != count)
      file_.wrong(line, words.size() > count ? words[count].at : line.text.size(),
                  fmt::format("a transition has {} states here (the cell, {} neighbours, the new state), "
                              "not {}",
                              count, n, words.size()));
    // A variable that occurs more than once stands for the same state in all its positions.
    std::vector<std::string> bound;
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (!variables_.contains(words[i].text)) {
        if (i + 1 == words.size() || !words[i].text.empty()) (void)statesOf(line, words[i]);
        continue;
      }
      const auto same = [&](const RuleWord& other) { return other.text == words[i].text; };
      const auto often = std::count_if(words.begin(), words.end(), same);
      if (i + 1 == words.size() && often == 1)
        file_.wrong(line, words[i].at,
                    fmt::format("the new state is the variable \"{}\", which is not the state of any input "
                                "of this transition",
                                words[i].text));
      if (often > 1 && std::find(bound.begin(), bound.end(), words[i].text) == bound.end())
        bound.emplace_back(words[i].text);
    }
    std::map<std::string, int, std::less<>> values;
    expand(line, words, bound, 0, values);
  }

  void expand(const RuleFileText::Line& line, const std::vector<RuleWord>& words,
              const std::vector<std::string>& bound, std::size_t next,
              std::map<std::string, int, std::less<>>& values) {
    if (next < bound.size()) {
      const States states = variables_.find(bound[next])->second;
      for (int s = 0; s < states_; ++s) {
        if (!states[static_cast<std::size_t>(s)]) continue;
        values[bound[next]] = s;
        expand(line, words, bound, next + 1, values);
      }
      return;
    }
    RuleTransition transition;
    for (std::size_t i = 0; i < words.size(); ++i) {
      States states;
      if (const auto found = values.find(words[i].text); found != values.end())
        states.set(static_cast<std::size_t>(found->second));
      else
        states = statesOf(line, words[i]);
      if (i + 1 < words.size())
        transition.inputs[i] = states;
      else
        for (int s = 0; s < states_; ++s)
          if (states[static_cast<std::size_t>(s)]) transition.output = s;
    }
    symmetric(line, transition);
  }

  static std::string keyOf(const RuleTransition& t) {
    std::string key;
    for (const States& states : t.inputs) key += states.to_string();
    return key;
  }

  void push(const RuleFileText::Line& line, const RuleTransition& transition) {
    if (table_.size() >= maxTransitions)
      file_.wrong(line, 0,
                  fmt::format("the table has more than {} transitions, variables and symmetries "
                              "written out",
                              maxTransitions));
    table_.push_back(transition);
  }

  void symmetric(const RuleFileText::Line& line, const RuleTransition& transition) {
    const int n = neighboursOf(shape_);
    if (symmetry_ == "permute") return permuted(line, transition);
    if (moves_.empty()) {
      moves_ = permutations(symmetry_, n);
      if (moves_.empty())
        file_.wrong(symmetryLine_, symmetryAt_,
                    fmt::format("the symmetry \"{}\" is not known for this neighbourhood", symmetry_));
    }
    std::set<std::string> seen;
    for (const std::vector<int>& move : moves_) {
      RuleTransition moved = transition;
      for (int i = 0; i < n; ++i)
        moved.inputs[static_cast<std::size_t>(move[static_cast<std::size_t>(i)]) + 1] =
            transition.inputs[static_cast<std::size_t>(i) + 1];
      if (moves_.size() == 1 || seen.insert(keyOf(moved)).second) push(line, moved);
    }
  }

  /// Adds the transition for every distinct order of the neighbours.
  void permuted(const RuleFileText::Line& line, const RuleTransition& transition) {
    const auto n = static_cast<std::size_t>(neighboursOf(shape_));
    std::vector<std::pair<std::string, States>> sets;
    for (std::size_t i = 1; i <= n; ++i)
      sets.emplace_back(transition.inputs[i].to_string(), transition.inputs[i]);
    const auto less = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::sort(sets.begin(), sets.end(), less);
    do {
      RuleTransition moved = transition;
      for (std::size_t i = 0; i < n; ++i) moved.inputs[i + 1] = sets[i].second;
      push(line, moved);
    } while (std::next_permutation(sets.begin(), sets.end(), less));
  }

  const RuleFileText& file_;
  std::vector<RuleFileText::Line> lines_;
  int states_ = 0;
  TableShape shape_ = TableShape::vonNeumann;
  std::string symmetry_ = "rotate4";
  RuleFileText::Line symmetryLine_{};
  std::size_t symmetryAt_ = 0;
  std::vector<std::vector<int>> moves_;
  std::map<std::string, States, std::less<>> variables_;
  std::vector<RuleTransition> table_;
};

}  // namespace

CellRule parseRuleTable(const RuleFileText& file) {
  return TableReader(file).read();
}

}  // namespace simreel::sim

#include "sim/automata/file/rule_file.hpp"

#include "base/file.hpp"
#include "sim/automata/file/rule_table.hpp"
#include "sim/automata/file/rule_text.hpp"
#include "sim/automata/file/rule_tree.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace simreel::sim {

namespace {

constexpr std::size_t maxRuleBytes = std::size_t{64} << 20;

/// Parses the section @TREE.
CellRule parseTree(const RuleFileText& file) {
  int states = 0, neighbours = 0, nodes = 0, read = 0;
  auto tree = std::make_shared<RuleTree>();
  std::vector<int> depths;
  RuleFileText::Line last{};
  for (const RuleFileText::Line& line : file.section("@TREE")) {
    last = line;
    if (const std::size_t equals = line.text.find('='); equals != std::string_view::npos) {
      const std::string_view key = line.text.substr(0, equals);
      const auto value = wordsOf(line.text.substr(equals + 1), false);
      if (value.empty()) file.wrong(line, equals + 1, "a number is missing here");
      const std::size_t at = equals + 1 + value[0].at;
      if (key.starts_with("num_states"))
        states = file.number(line, at, value[0].text, 256, "the number of states");
      else if (key.starts_with("num_neighbors"))
        neighbours = file.number(line, at, value[0].text, 8, "the number of neighbours");
      else if (key.starts_with("num_nodes"))
        nodes =
            file.number(line, at, value[0].text, static_cast<int>(maxTreeItems / 2), "the number of nodes");
      continue;
    }
    if (states < 2 || (neighbours != 4 && neighbours != 8) || nodes < 1)
      file.wrong(line, 0,
                 "num_states (2 to 256), num_neighbors (4 or 8) and num_nodes must come before the nodes");
    const auto words = wordsOf(line.text, false);
    if (words.size() != static_cast<std::size_t>(states) + 1)
      file.wrong(line, 0, fmt::format("a node has {} numbers, not {}", states + 1, words.size()));
    if (read == nodes) file.wrong(line, 0, fmt::format("more nodes than the {} of num_nodes", nodes));
    const int depth = file.number(line, words[0].at, words[0].text, neighbours + 1, "the depth of a node");
    if (depth == 0) file.wrong(line, words[0].at, "the depth of a node is at least 1");
    for (std::size_t i = 1; i < words.size(); ++i) {
      const int value = file.number(line, words[i].at, words[i].text, depth == 1 ? states - 1 : read - 1,
                                    depth == 1 ? "a state" : "the number of a node before");
      if (depth > 1 && depths[static_cast<std::size_t>(value)] != depth - 1)
        file.wrong(line, words[i].at,
                   fmt::format("node {} has depth {}, not {}", value,
                               depths[static_cast<std::size_t>(value)], depth - 1));
      tree->items.push_back(static_cast<std::uint32_t>(depth == 1 ? value : value * states));
    }
    if (tree->items.size() > maxTreeItems)
      file.wrong(line, 0, fmt::format("the nodes have more than {} numbers", maxTreeItems));
    depths.push_back(depth);
    ++read;
  }
  if (read != nodes || depths.empty() || depths.back() != neighbours + 1)
    file.wrong(fmt::format("@TREE ends after {} of {} nodes{}; the file may be cut off", read, nodes,
                           read == nodes ? "; the last node is not the root" : ""));
  CellRule rule;
  rule.family = CellRule::Family::tree;
  rule.states = states;
  tree->neighbours = neighbours;
  tree->root = static_cast<std::uint32_t>((read - 1) * states);
  rule.tree = std::move(tree);
  return rule;
}

/// Converts an 8-bit sRGB level to linear light by a polynomial, c (c (0.305306011 c + 0.682171111) +
/// 0.012522878), whose error is at most 0.2 % of full scale. Plain arithmetic gives the same bits on every
/// machine.
float lightOf(double level) {
  const double c = level / 255;
  return static_cast<float>(c * (c * (0.305306011 * c + 0.682171111) + 0.012522878));
}

glm::vec3 lightOf(const std::array<int, 6>& levels, std::size_t first) {
  return {lightOf(levels[first]), lightOf(levels[first + 1]), lightOf(levels[first + 2])};
}

/// Parses colours: either "1 0 128 255 blue" (state, red, green, blue, name), or a gradient over all states
/// except 0: "0 0 255 255 0 0" (first and last colour).
std::vector<glm::vec3> parseColors(const RuleFileText& file, int states) {
  std::vector<glm::vec3> colors;
  const auto count = static_cast<std::size_t>(states);
  for (const RuleFileText::Line& line : file.section("@COLORS")) {
    const auto words = wordsOf(line.text, false);
    std::array<int, 6> levels{};
    std::size_t numbers = 0;
    for (const RuleWord& word : words) {
      if (numbers == levels.size() || word.text[0] < '0' || word.text[0] > '9') break;
      levels[numbers++] = file.number(line, word.at, word.text, 255, "a colour's level");
    }
    if (numbers < 4)
      file.wrong(
          line, 0,
          "a colour line needs a state and three levels, as in \"1 0 128 255\", or two times three levels");
    if (colors.empty()) {
      colors.assign(count, glm::vec3(1));
      colors[0] = glm::vec3(0);
    }
    if (numbers == 6) {
      for (std::size_t s = 1; s < count; ++s) {
        const double t = count > 2 ? static_cast<double>(s - 1) / static_cast<double>(count - 2) : 0;
        for (int c = 0; c < 3; ++c)
          colors[s][c] = lightOf(levels[static_cast<std::size_t>(c)] * (1 - t) +
                                 levels[static_cast<std::size_t>(c) + 3] * t);
      }
    } else if (static_cast<std::size_t>(levels[0]) < count) {
      colors[static_cast<std::size_t>(levels[0])] = lightOf(levels, 1);
    }
  }
  return colors;
}

}  // namespace

CellRule parseRuleFile(std::string_view text, const std::string& name) {
  const RuleFileText file(text, name);
  const auto head = file.section("@RULE");
  if (head.empty()) file.wrong("this is not a rule file, which begins with @RULE and a name");
  const int table = file.find("@TABLE"), tree = file.find("@TREE");
  if (table < 0 && tree < 0)
    file.wrong(
        "the file has neither @TABLE nor @TREE; it may be cut off, or only name icons of another rule");
  CellRule rule = tree < 0 || (table >= 0 && table < tree) ? parseRuleTable(file) : parseTree(file);
  rule.name = head[0].text.substr(0, head[0].text.find(' '));
  rule.colors = parseColors(file, rule.states);
  return rule;
}

CellRule readRuleFile(const std::filesystem::path& file) {
  return parseRuleFile(readFile(file, "rule", maxRuleBytes), file.string());
}

}  // namespace simreel::sim

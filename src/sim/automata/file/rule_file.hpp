#pragma once
#include "sim/automata/rule/cell_rule.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace simreel::sim {

/// Reads a rule in Golly's format .rule: @RULE with its name, then @TABLE (variables and symmetries) or
/// @TREE, whichever comes first, and @COLORS; other sections are ignored. Neighbourhoods: vonNeumann,
/// Moore, hexagonal, oneDimensional. Throws UserError(usage) with file:line:column for unreadable,
/// truncated or contradictory content and for states beyond the rule's.
[[nodiscard]] CellRule readRuleFile(const std::filesystem::path& file);
/// Parses a rule from text as readRuleFile() does; `name` is the file's name in messages.
[[nodiscard]] CellRule parseRuleFile(std::string_view text, const std::string& name);

}  // namespace simreel::sim

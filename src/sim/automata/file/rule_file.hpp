#pragma once
#include "sim/automata/rule/cell_rule.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace simreel::sim {

/// Reads a rule in Golly's format .rule: @RULE with its name, then @TABLE (variables and symmetries) or
/// @TREE, whichever comes first, and @COLORS. Ignores other sections. The supported neighbourhoods are
/// vonNeumann, Moore, hexagonal and oneDimensional. Throws UserError(usage) with file:line:column for
/// unreadable, truncated or contradictory content and for states that the rule does not have.
[[nodiscard]] CellRule readRuleFile(const std::filesystem::path& file);
/// Parses a rule from text like readRuleFile(). `name` is the file's name in messages.
[[nodiscard]] CellRule parseRuleFile(std::string_view text, const std::string& name);

}  // namespace simreel::sim

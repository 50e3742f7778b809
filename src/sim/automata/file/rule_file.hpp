#pragma once
#include "sim/automata/rule/cell_rule.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace simreel::sim {

/// Reads a rule in Golly's format .rule: @RULE with its name, then @TABLE (variables and symmetries) or
/// @TREE, whichever comes first, and @COLORS; other sections are passed over. Neighbourhoods: vonNeumann,
/// Moore, hexagonal, oneDimensional. Throws UserError(usage) with file:line:column for what cannot be read,
/// is cut off, contradicts itself, or names states beyond the rule's.
[[nodiscard]] CellRule readRuleFile(const std::filesystem::path& file);
/// The same from text; `name` is what messages call it.
[[nodiscard]] CellRule parseRuleFile(std::string_view text, const std::string& name);

}  // namespace simreel::sim

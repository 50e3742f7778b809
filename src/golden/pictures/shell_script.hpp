#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace simreel::golden {

/// A word in a command to be replaced by a value: "{scene}", "{output}".
struct Placeholder {
  std::string word;
  std::string variable;  ///< name of the shell variable that holds the value
  std::string value;
  std::string before = {};  ///< if not empty, one of its characters must follow the word
};

/// Replaces the placeholders in a shell command; the first match wins. Values are never parsed as shell
/// code: a value of letters, digits and the like is inserted as it is; any other is read from its shell
/// variable, quoted as needed at that place. Throws UserError(usage) if such a value is inside quotes
/// together with other words, because another shell may parse them (sh -c '...').
[[nodiscard]] std::string fillIn(const std::string& command, const std::vector<Placeholder>& placeholders);

}  // namespace simreel::golden

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
  std::string before = {};  ///< characters of which one must follow the word; if empty, any character may
                            ///< follow
};

/// Replaces the placeholders in a shell command. If several placeholders match at a position, the first one
/// counts. Values are never parsed as shell code. A value that contains only letters, digits and other
/// harmless characters is inserted unchanged. Any other value is read from its shell variable, quoted as
/// needed at that position. Throws UserError(usage) if such a value is inside quotes together with other
/// words, because another shell may parse them (sh -c '...').
[[nodiscard]] std::string fillIn(const std::string& command, const std::vector<Placeholder>& placeholders);

}  // namespace simreel::golden

#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace simreel::golden {

/// A word of a command that a value takes the place of: "{scene}", "{output}".
struct Placeholder {
  std::string word;
  std::string variable;  ///< of the shell, which holds the value
  std::string value;
  std::string before = {};  ///< characters one of which has to follow; empty: anything may
};

/// The command with its placeholders filled in, first match first. A value never becomes text that the
/// shell reads as a command: one of letters, digits and such stands there as it is, any other is taken from
/// its variable, quoted as the place needs it. Throws UserError(usage) where such a value stands among
/// other words inside quotes, which another shell may read (sh -c '...').
[[nodiscard]] std::string fillIn(const std::string& command, const std::vector<Placeholder>& placeholders);

}  // namespace simreel::golden

#pragma once
#include <span>
#include <string_view>

namespace simreel::cli {

/// Facts about a kind of object that the reference prints in addition to the kind's parameters.
struct KindNotes {
  std::string_view kind;
  std::string_view states;   ///< state arrays under the names that `simreel trace` and `bake` use, in the
                             ///< form "name: meaning|..."
  std::string_view sources;  ///< papers and books, separated by "|"; may be empty
};

/// Returns the notes of every kind, in the order of `simreel list`.
[[nodiscard]] std::span<const KindNotes> kindNotes();
/// Returns the notes of a kind, or empty notes for an unknown name.
[[nodiscard]] KindNotes notesOf(std::string_view kind);

}  // namespace simreel::cli

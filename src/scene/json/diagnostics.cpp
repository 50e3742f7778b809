#include "scene/json/diagnostics.hpp"

#include "base/text.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

/// Returns the part of the line around an error, followed by a second line with a caret below the error.
std::string excerpt(std::string_view line, std::size_t begin, std::size_t end) {
  constexpr std::size_t before = 60, max = 110;
  std::size_t from = 0, to = line.size();
  if (line.size() > max) {
    from = begin > before ? begin - before : 0;
    while (from > 0 && continues(line[from])) --from;
    to = std::min(line.size(), from + max);
    while (to < line.size() && continues(line[to])) ++to;
  }
  std::string shown = from > 0 ? "  ..." : "  ";
  std::string marks(shown.size(), ' ');
  for (std::size_t at = from; at < to;) {
    const std::size_t length = std::max<std::size_t>(1, codePointLength(line, at));
    const std::string glyph = line[at] == '\t' ? "    " : printable(line.substr(at, length));
    const std::size_t width = line[at] == '\t' ? 4 : 1;
    shown += glyph;
    if (at <= begin && begin < at + length) {
      marks += '^';
      if (begin + length < end) marks.append(width - 1, '~');
    } else if (at < begin) {
      marks.append(width, ' ');
    } else if (at < end) {
      marks.append(width, '~');
    }
    at += length;
  }
  if (begin >= to) marks += '^';
  if (to < line.size()) shown += "...";
  return shown + "\n" + marks + "\n";
}

}  // namespace

Diagnostics::Diagnostics(std::string file, std::string_view text) {
  addFile(std::move(file), text);
}

int Diagnostics::addFile(std::string file, std::string_view text) {
  sources_.push_back({std::move(file), {}, text, true});
  return static_cast<int>(sources_.size()) - 1;
}

int Diagnostics::addOverride(std::string argument) {
  std::string name =
      "-D " + (argument.size() <= 60 ? argument : argument.substr(0, argument.find('=') + 1) + "...");
  sources_.push_back({std::move(name), std::move(argument), {}, false});
  return static_cast<int>(sources_.size()) - 1;
}

void Diagnostics::add(Place place, std::string message) {
  ++count_;
  if (!full()) errors_.push_back({place, std::move(message)});
}

bool Diagnostics::anyWithin(Place place) const {
  return full() || std::any_of(errors_.begin(), errors_.end(), [&](const Error& error) {
           return error.place.source == place.source && error.place.begin >= place.begin &&
                  error.place.begin < place.end;
         });
}

void Diagnostics::remark(Place place, std::string message) {
  if (remarks_.size() < maxKept) remarks_.push_back({place, std::move(message)});
}

bool Diagnostics::isOverride(int source) const {
  return !sources_[static_cast<std::size_t>(source)].isFile;
}

std::string_view Diagnostics::sourceText(int source) const {
  const Source& found = sources_[static_cast<std::size_t>(source)];
  return found.isFile ? found.text : std::string_view(found.owned);
}

std::string_view Diagnostics::textAt(Place place) const {
  return sourceText(place.source).substr(place.begin, place.end - place.begin);
}

Diagnostics::Line Diagnostics::lineOf(Place place) const {
  const std::string_view text = sourceText(place.source);
  const std::size_t at = std::min(place.begin, text.size());
  // On the first line rfind() returns npos, and npos + 1 is 0.
  std::size_t begin = text.substr(0, at).rfind('\n') + 1;
  std::size_t end = std::min(text.find('\n', at), text.size());
  if (end > begin && text[end - 1] == '\r') --end;
  if (begin == 0 && text.starts_with(byteOrderMark) && at >= byteOrderMark.size())
    begin = byteOrderMark.size();
  return {begin, std::max({end, begin, at}), at};
}

Diagnostics::Position Diagnostics::positionOf(Place place) const {
  const std::string_view text = sourceText(place.source);
  const Line line = lineOf(place);
  const std::string_view head = text.substr(line.begin, line.at - line.begin);
  const auto column =
      head.size() - static_cast<std::size_t>(std::count_if(head.begin(), head.end(), continues)) + 1;
  const auto number =
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(line.at), '\n') + 1;
  return {static_cast<int>(number), static_cast<int>(column)};
}

std::string Diagnostics::where(Place place) const {
  const Source& source = sources_[static_cast<std::size_t>(place.source)];
  const std::string name = oneLine(source.name);
  if (!source.isFile) return name;
  const Position position = positionOf(place);
  return fmt::format("{}:{}:{}", name, position.line, position.column);
}

std::string Diagnostics::describe(const Error& error, const char* kind) const {
  const Line line = lineOf(error.place);
  return fmt::format("{}: {}: {}\n{}", where(error.place), kind, oneLine(error.message),
                     excerpt(sourceText(error.place.source).substr(line.begin, line.end - line.begin),
                             line.at - line.begin, std::max(error.place.end, line.at + 1) - line.begin));
}

std::vector<const Diagnostics::Error*> Diagnostics::inOrder(const std::vector<Error>& found) {
  std::vector<const Error*> ordered;
  ordered.reserve(found.size());
  for (const Error& error : found) ordered.push_back(&error);
  std::stable_sort(ordered.begin(), ordered.end(), [](const Error* a, const Error* b) {
    return std::tie(a->place.source, a->place.begin) < std::tie(b->place.source, b->place.begin);
  });
  return ordered;
}

std::vector<Problem> Diagnostics::problems(const std::function<std::string(Place)>& pathOf) const {
  std::vector<Problem> found;
  for (const Error* error : inOrder(errors_)) {
    Problem problem{{}, 0, 0, pathOf(error->place), error->message};
    const Source& source = sources_[static_cast<std::size_t>(error->place.source)];
    if (source.isFile) {
      const Position position = positionOf(error->place);
      problem.file = source.name;
      problem.line = position.line;
      problem.column = position.column;
    } else if (problem.path.empty()) {
      problem.path = source.owned.substr(0, source.owned.find('='));
    }
    found.push_back(std::move(problem));
  }
  return found;
}

std::vector<std::string> Diagnostics::remarks() const {
  std::vector<std::string> remarks;
  for (const Error* remark : inOrder(remarks_)) {
    remarks.push_back(describe(*remark, "warning"));
    remarks.back().pop_back();
  }
  return remarks;
}

std::string Diagnostics::report() const {
  constexpr std::size_t maxShown = 50;
  const std::vector<const Error*> ordered = inOrder(errors_);
  std::string out;
  for (std::size_t i = 0; i < std::min(maxShown, ordered.size()); ++i)
    out += describe(*ordered[i], "error");
  if (count_ > maxShown) out += fmt::format("and {} more\n", count_ - maxShown);
  if (!out.empty()) out.pop_back();  // Removes the final newline, because callers add one.
  return out;
}

}  // namespace simreel::scene

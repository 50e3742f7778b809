#include "api/failure.hpp"

#include "base/error.hpp"
#include "frame/interrupt.hpp"
#include "scene/json/scene_error.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

namespace simreel {

Error::Error(ErrorKind kind, std::string message, std::vector<Mistake> mistakes)
    : kind_(kind), message_(std::move(message)), mistakes_(std::move(mistakes)) {}
Error::~Error() = default;
Error::Error(const Error&) = default;
Error& Error::operator=(const Error&) = default;
const char* Error::what() const noexcept {
  return message_.c_str();
}
ErrorKind Error::kind() const noexcept {
  return kind_;
}
const std::vector<Mistake>& Error::mistakes() const noexcept {
  return mistakes_;
}

namespace api {

namespace {

ErrorKind kindOf(const UserError& error) {
  switch (error.code()) {
    case ExitCode::device:
      return ErrorKind::device;
    case ExitCode::different:
      return ErrorKind::different;
    case ExitCode::inputOutput:
      return ErrorKind::inputOutput;
    default:
      return error.form() == UserError::Form::report ? ErrorKind::scene : ErrorKind::usage;
  }
}

/// Returns the name that a message suggests, which is x in `did you mean "x"?`.
std::string suggestedBy(std::string_view message) {
  constexpr std::string_view words = "did you mean \"";
  const std::size_t at = message.find(words);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = message.substr(at + words.size());
  return std::string(rest.substr(0, rest.find('"')));
}

std::vector<Mistake> mistakesOf(const std::vector<scene::Problem>& problems) {
  std::vector<Mistake> mistakes;
  mistakes.reserve(problems.size());
  for (const scene::Problem& one : problems)
    mistakes.push_back({one.file, one.line, one.column, one.path, one.message, suggestedBy(one.message)});
  return mistakes;
}

/// Returns the mistakes in a compiler's report. They are its lines of the form "file:line:column: error:
/// message".
std::vector<Mistake> mistakesIn(std::string_view report) {
  constexpr std::string_view mark = ": error: ";
  std::vector<Mistake> mistakes;
  while (!report.empty()) {
    const std::string_view line = report.substr(0, report.find('\n'));
    report.remove_prefix(std::min(report.size(), line.size() + 1));
    const std::size_t end = line.find(mark);
    if (end == std::string_view::npos) continue;
    const std::string place(line.substr(0, end));
    Mistake mistake{place, 0, 0, {}, std::string(line.substr(end + mark.size())), suggestedBy(line)};
    const std::size_t second = place.rfind(':');
    const std::size_t first =
        second == std::string::npos || second == 0 ? second : place.rfind(':', second - 1);
    if (first != std::string::npos && second != std::string::npos && first < second) {
      mistake.line = std::atoi(place.c_str() + first + 1);
      mistake.column = std::atoi(place.c_str() + second + 1);
      if (mistake.line > 0) mistake.file = place.substr(0, first);
    }
    mistakes.push_back(std::move(mistake));
  }
  return mistakes;
}

/// Returns one mistake with the name that a sentence suggests, or an empty list if it suggests no name.
std::vector<Mistake> suggestionIn(const std::string& sentence) {
  std::string name = suggestedBy(sentence);
  if (name.empty()) return {};
  return {{{}, 0, 0, {}, sentence, std::move(name)}};
}

}  // namespace

void fail(ErrorKind kind, std::string message) {
  throw Error(kind, std::move(message));
}

void rethrowAsError(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const Error&) {
    throw;
  } catch (const scene::SceneError& error) {
    throw Error(ErrorKind::scene, error.what(), mistakesOf(error.problems()));
  } catch (const UserError& error) {
    throw Error(
        kindOf(error), error.what(),
        error.form() == UserError::Form::report ? mistakesIn(error.what()) : suggestionIn(error.what()));
  } catch (const frame::Interrupted&) {
    throw Error(ErrorKind::interrupted, "interrupted");
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::device, "not enough memory");
  } catch (const std::exception& error) {
    throw Error(ErrorKind::internal, error.what());
  }
}

}  // namespace api

}  // namespace simreel

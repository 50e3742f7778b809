#include "kernels/compile/learn.hpp"

#include "kernels/compile/messages.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace simreel::kernels {

namespace {

/// A file's tokens, and its global variables.
struct Scan {
  explicit Scan(const std::string& text)
      : code(withoutComments(text)), all(tokens(code)), declared(globals(code, all)) {}
  ~Scan() = default;
  Scan(const Scan&) = delete;
  Scan& operator=(const Scan&) = delete;

  std::string code;
  std::vector<Token> all;
  std::vector<Declaration> declared;
};

std::deque<Scan> scans(const Files& files) {
  std::deque<Scan> made;
  for (std::size_t i = 0; i < files.count(); ++i) made.emplace_back(files.text(i));
  return made;
}

bool isResource(const Declaration& one) {
  return !lengthFunction(one.type, "x").empty() || one.type.starts_with("Sampler") ||
         one.type.starts_with("sampler");
}

/// Returns the tokens of the statement that contains a line (first line: 1).
std::vector<Token> statement(const Scan& scan, int line) {
  std::size_t begin = 0;
  for (int i = 1; i < line && begin < scan.code.size(); ++i)
    begin = std::min(scan.code.find('\n', begin), scan.code.size() - 1) + 1;
  const std::size_t end = std::min(scan.code.find('\n', begin), scan.code.size());
  auto first =
      std::find_if(scan.all.begin(), scan.all.end(), [&](const Token& one) { return one.at >= begin; });
  auto last = std::find_if(first, scan.all.end(), [&](const Token& one) { return one.at >= end; });
  const auto stops = [](const Token& one) { return one.text == ";" || one.text == "{" || one.text == "}"; };
  while (first != scan.all.begin() && !stops(*(first - 1))) --first;
  while (last != scan.all.end() && !stops(*(last - 1))) ++last;
  return {first, last};
}

/// Learns which constants the shader assigns to. If there is no new one, takes the constants in the
/// rejected statement, because a function may assign to them.
void learnAssigned(Files& files, const Mistake& mistake) {
  const std::deque<Scan> all = scans(files);
  std::set<std::string, std::less<>> constants, assigned;
  for (const Scan& scan : all) {
    for (const Declaration& one : scan.declared)
      for (const Declarator& name : one.names)
        if (!one.constant && !one.shared && !isResource(one)) constants.emplace(name.name);
    assigned.merge(assignedNames(scan.all));
  }
  const std::size_t before = files.remedies.count();
  const auto add = [&](std::string_view name) {
    if (constants.find(name) != constants.end()) files.remedies.assigned.emplace(name);
  };
  for (const std::string& name : assigned) add(name);
  if (files.remedies.count() == before)
    for (const Token& token : statement(all[mistake.file], mistake.line)) add(token.text);
}

void learnMeasured(Files& files) {
  const std::deque<Scan> all = scans(files);
  std::set<std::string, std::less<>> resources;
  for (const Scan& scan : all)
    for (const Declaration& one : scan.declared)
      for (const Declarator& name : one.names)
        if (name.lengths.empty() && isResource(one)) resources.emplace(name.name);
  for (const Scan& scan : all)
    for (std::size_t i = 0; i + 2 < scan.all.size(); ++i)
      if (scan.all[i + 1].text == "." && scan.all[i + 2].text == "Length" &&
          resources.find(scan.all[i].text) != resources.end())
        files.remedies.measured.emplace(scan.all[i].text);
}

void learnNamespaces(Files& files) {
  for (const Scan& scan : scans(files))
    for (std::size_t i = 0; i + 2 < scan.all.size(); ++i)
      if (scan.all[i].text == "namespace" && scan.all[i + 2].text == "{")
        files.remedies.dissolved.emplace(scan.all[i + 1].text);
}

bool asksForLength(const Files& files, const Mistake& mistake) {
  const Scan scan(files.text(mistake.file));
  const std::vector<Token> tokens = statement(scan, mistake.line);
  return std::any_of(tokens.begin(), tokens.end(), [](const Token& one) { return one.text == "Length"; });
}

}  // namespace

bool learn(Files& files, std::string_view log) {
  const std::size_t before = files.remedies.count();
  for (const Mistake& mistake : told(log, files.count())) {
    const auto says = [&](std::string_view words) {
      return mistake.message.find(words) != std::string::npos;
    };
    if (says("l-value required \"$Global\""))
      learnAssigned(files, mistake);
    else if (says("Macro redefined"))
      files.remedies.redefined.emplace(mistake.file, mistake.line);
    else if (says("no matching overloaded function found") &&
             (mistake.token == "select" || mistake.token == "and" || mistake.token == "or"))
      files.remedies.functions.insert(mistake.token);
    else if (says("DX9"))
      files.remedies.functions.insert("tex2D");
    else if (mistake.line > 0 && asksForLength(files, mistake))
      learnMeasured(files);
  }
  if (files.remedies.count() == before) learnNamespaces(files);
  return files.remedies.count() > before;
}

}  // namespace simreel::kernels

#include "kernels/compile/learn.hpp"

#include "kernels/compile/messages.hpp"
#include "kernels/source/initializers.hpp"
#include "kernels/source/loop_variables.hpp"
#include "kernels/source/overloads.hpp"
#include "kernels/source/scan.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

bool isResource(const Declaration& one) {
  return !lengthFunction(one.type, "x").empty() || one.type.starts_with("Sampler") ||
         one.type.starts_with("sampler");
}

/// Returns the tokens of the statement that contains line `line`, counted from 1.
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

/// Records the constants to which the shader assigns. If none of them is new, records the constants in the
/// rejected statement, because the statement may call a function that assigns to them.
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

/// Records the namespaces of the files. Returns true if one of them is new.
bool learnNamespaces(Files& files) {
  const std::size_t before = files.remedies.dissolved.size();
  for (const Scan& scan : scans(files))
    for (std::size_t i = 0; i + 2 < scan.all.size(); ++i)
      if (scan.all[i].text == "namespace" && scan.all[i + 2].text == "{")
        files.remedies.dissolved.emplace(scan.all[i + 1].text);
  return files.remedies.dissolved.size() > before;
}

/// Changes "ConstantBuffer<T> x" to "cbuffer simreel_block_x { T x; }". Returns true if one of these
/// objects is new.
bool learnConstantBuffers(Files& files) {
  const std::size_t before = files.remedies.unpacked.size();
  const std::deque<Scan> scanned = scans(files);
  for (std::size_t file = 0; file < scanned.size(); ++file) {
    const Scan& scan = scanned[file];
    for (std::size_t i = 0; i + 5 < scan.all.size(); ++i) {
      if (scan.all[i].text != "ConstantBuffer" || scan.all[i + 1].text != "<") continue;
      std::size_t close = i + 2;
      while (close + 2 < scan.all.size() && scan.all[close].text != ">") ++close;
      const Token& name = scan.all[close + 1];
      const std::string_view next = scan.all[close + 2].text;
      if (!name.isWord() || (next != ";" && next != ":")) continue;
      std::size_t end = close + 2;
      while (end + 1 < scan.all.size() && scan.all[end].text != ";") ++end;
      if (!files.remedies.unpacked.emplace(name.text).second) continue;
      const std::size_t type = scan.all[i + 2].at;
      Edits& edits = files.remedies.edits[file];
      edits.replace(scan.all[i].at, name.end(), fmt::format("cbuffer simreel_block_{}", name.text));
      edits.replace(
          scan.all[end].at, scan.all[end].end(),
          fmt::format(" {{ {} {}; }};", scan.code.substr(type, scan.all[close].at - type), name.text));
    }
  }
  return files.remedies.unpacked.size() > before;
}

/// Adds the missing braces to the flat initializers of a file. Does nothing if that has already been done.
void learnInitializers(Files& files, const Mistake& mistake) {
  if (files.remedies.nested.contains(mistake.file)) return;
  files.remedies.nested.insert(mistake.file);
  files.remedies.edits[mistake.file].add(nestedInitializers(scans(files), mistake.file));
}

/// Adds overloads of the user's function `name`.
void learnOverloads(Files& files, const std::string& name) {
  if (files.remedies.shortened.contains(name)) return;
  const std::deque<Scan> all = scans(files);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (const Edits more = shorteningOverloads(all[i], name); !more.empty()) {
      files.remedies.edits[i].add(more);
      files.remedies.shortened.insert(name);
    }
}

/// Moves the declaration of a variable before the last loop that declares it.
void learnLoopVariable(Files& files, const Mistake& mistake) {
  const std::string key = mistake.token + std::to_string(mistake.line);
  if (files.remedies.loopVariables.contains(key)) return;
  const Edits more = declaredBeforeLoop(Scan(files.text(mistake.file)), mistake.token, mistake.line);
  if (more.empty()) return;
  files.remedies.edits[mistake.file].add(more);
  files.remedies.loopVariables.insert(key);
}

bool asksForLength(const Files& files, const Mistake& mistake) {
  const Scan scan(files.text(mistake.file));
  const std::vector<Token> tokens = statement(scan, mistake.line);
  return std::any_of(tokens.begin(), tokens.end(), [](const Token& one) { return one.text == "Length"; });
}

/// Returns true if an initializer, from token `i` to the semicolon, calls a function that the user's files
/// define.
bool callsFunction(const std::deque<Scan>& all, const Scan& scan, std::size_t i) {
  for (; i + 1 < scan.all.size() && scan.all[i].text != ";"; ++i) {
    const Token& name = scan.all[i];
    if (!name.isWord() || scan.all[i + 1].text != "(" || numeric(name.text)) continue;
    for (const Scan& other : all)
      if (bodyOf(other, name.text) != 0) return true;
  }
  return false;
}

/// Removes the initializer from "static T x = f();" and appends it to `starts` as an assignment.
void takeStart(const std::deque<Scan>& all, const Scan& scan, const Declaration& one, Edits& edits,
               std::string& starts) {
  const Declarator& name = one.names[0];
  std::size_t i = 0;
  while (scan.all[i].at != name.at) ++i;
  std::size_t type = i;
  while (scan.all[type].text.data() != one.type.data()) --type;
  while (i < scan.all.size() && scan.all[i].text != "=" && scan.all[i].text != ";") ++i;
  if (scan.all[i].text != "=" || !callsFunction(all, scan, i + 1)) return;
  const std::size_t begin = scan.all[i].at, end = one.end - 1;
  starts += fmt::format(" {} {};", name.name, scan.code.substr(begin, end - begin));
  edits.replace(begin, end, "");
  for (std::size_t k = type; k-- > 0 && (scan.all[k].text == "const" || scan.all[k].text == "static");)
    if (scan.all[k].text == "const") edits.replace(scan.all[k].at, scan.all[k].end(), "");
}

}  // namespace

bool moveStaticInitializers(Files& files, const std::string& entry) {
  Remedies& remedies = files.remedies;
  std::string& starts = remedies.starts;
  const bool done = starts.empty() || remedies.started.contains(entry);
  if (done && remedies.searched.size() == files.count()) return false;
  const std::deque<Scan> all = scans(files);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (remedies.searched.contains(i)) continue;
    remedies.searched.insert(i);
    Edits edits;
    for (const Declaration& one : all[i].declared)
      if (one.constant && one.names.size() == 1 && one.names[0].lengths.empty())
        takeStart(all, all[i], one, edits, starts);
    if (!edits.empty()) remedies.edits[i].add(edits);
  }
  std::replace(starts.begin(), starts.end(), '\n', ' ');
  if (starts.empty() || remedies.started.contains(entry)) return false;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (const std::size_t body = bodyOf(all[i], entry); body != 0) remedies.edits[i].insert(body, starts);
  remedies.started.insert(entry);
  return true;
}

bool addRemedies(Files& files, std::string_view log) {
  const std::size_t before = files.remedies.count();
  for (const Mistake& mistake : errorsInLog(log, files.count())) {
    const auto says = [&](std::string_view words) {
      return mistake.message.find(words) != std::string::npos;
    };
    if (says("l-value required \"$Global\""))
      learnAssigned(files, mistake);
    else if (says("Macro redefined"))
      files.remedies.redefined.emplace(mistake.file, mistake.line);
    else if (says("no matching overloaded function found") &&
             (mistake.token == "select" || mistake.token == "and" || mistake.token == "or" ||
              mistake.token == "NonUniformResourceIndex"))
      files.remedies.functions.insert(mistake.token);
    else if (says("no matching overloaded function found") && !learnConstantBuffers(files) &&
             !learnNamespaces(files))
      learnOverloads(files, mistake.token);
    else if (mistake.token == "constructor" || mistake.token == "initializer list")
      learnInitializers(files, mistake);
    else if (says("undeclared identifier") || says("unknown variable"))
      learnLoopVariable(files, mistake);
    else if (says("already has a body") && !files.remedies.dissolved.empty())
      files.remedies.prefixed.insert(mistake.token);
    else if (says("DX9"))
      files.remedies.functions.insert("tex2D");
    else if (mistake.line > 0 && asksForLength(files, mistake))
      learnMeasured(files);
  }
  return files.remedies.count() > before || learnNamespaces(files);
}

}  // namespace simreel::kernels

// Writes JUnit XML that Jenkins, GitLab and others can read. tests/unit/junit.xsd is its schema.
#include "golden/report/junit.hpp"

#include "golden/baseline/origin.hpp"
#include "golden/report/words.hpp"
#include "golden/result.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <pugixml.hpp>
#include <sstream>

#include <fmt/format.h>

namespace simreel::golden {

namespace {

using pugi::xml_node;

void setText(xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(cleanText(value).c_str());
}

/// Writes seconds with three decimals, because the Jenkins schema allows no exponent.
void setSeconds(xml_node node, double seconds) {
  const double finite = std::isfinite(seconds) ? std::max(seconds, 0.0) : 0.0;
  setText(node, "time", fmt::format("{:.3f}", finite));
}

void addBody(xml_node node, const std::string& text) {
  node.append_child(pugi::node_pcdata).set_value(cleanText(text).c_str());
}

std::string imageLines(const SuiteResult& suite, const SceneResult& scene) {
  std::string lines;
  for (const FrameResult& frame : scene.frames) {
    const std::string which = suite.unit == "picture" ? "" : fmt::format("frame {} ", frame.frame);
    const auto add = [&](const std::string& what, const std::string& path) {
      if (!path.empty()) lines += fmt::format("{}{}: {}\n", which, what, path);
    };
    add("expected", frame.expectedImage);
    add("actual", frame.actualImage);
    add("difference", frame.differenceImage);
    add("FLIP", frame.flipImage);
    for (const OtherPicture& other : frame.others) add(other.label, other.image);
  }
  return lines;
}

std::string failureBody(const SuiteResult& suite, const SceneResult& scene) {
  std::string body;
  for (const std::string& reason : reasons(scene)) body += reason + "\n";
  body += imageLines(suite, scene);
  if (!suite.acceptCommand.empty()) body += "To accept: " + suite.acceptCommand + "\n";
  return body;
}

std::string outputText(const SuiteResult& suite, const SceneResult& scene) {
  std::string text;
  if (scene.status == Status::flaky && suite.allowFlaky) text += "flaky: " + flakyText(scene) + "\n";
  for (std::size_t i = 0; i < scene.attempts.size(); ++i)
    for (const std::string& message : scene.attempts[i].messages)
      text += fmt::format("attempt {}: {}\n", i + 1, message);
  if (!scene.asked.empty() && scene.asked != requiredMatchName(RequiredMatch::exact) &&
      scene.asked != requiredMatchName(RequiredMatch::equal))
    text += "pictures compared " + comparedText(scene) + "\n";
  for (const std::string& note : scene.notes) text += "note: " + note + "\n";
  return text + imageLines(suite, scene);
}

/// Returns one attachment per line. Such a line must not contain other text.
std::string attachments(const SceneResult& scene, const std::filesystem::path& pictures) {
  std::vector<std::string> paths;
  const auto add = [&](const std::string& path) {
    if (!path.empty() && std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
  };
  const auto addFrame = [&](const FrameResult& frame) {
    for (const std::string& path : {frame.actualImage, frame.expectedImage, frame.differenceImage})
      add(path);
    for (const OtherPicture& other : frame.others) add(other.image);
  };
  if (const FrameResult* worst = worstFrame(scene)) addFrame(*worst);
  for (const FrameResult& frame : scene.frames) addFrame(frame);
  std::string lines;
  for (const std::string& path : paths)
    lines += fmt::format("[[ATTACHMENT|{}]]\n", (pictures / path).lexically_normal().generic_string());
  return lines;
}

std::string folderOf(const SceneResult& scene) {
  std::string folder = std::filesystem::path(scene.file).parent_path().string();
  if (!folder.empty()) return folder;
  return scene.file.empty() ? "simreel" : scene.file;
}

void addCase(xml_node suiteNode, const SuiteResult& suite, const SceneResult& scene,
             const std::filesystem::path& pictures) {
  xml_node node = suiteNode.append_child("testcase");
  setText(node, "classname", folderOf(scene));
  setText(node, "name", scene.name);
  setSeconds(node, scene.seconds);
  if (scene.status == Status::xfail) {
    const std::string reason = scene.xfail.empty() ? firstReason(scene) : scene.xfail;
    setText(node.append_child("skipped"), "message", "expected failure: " + reason);
  } else if (isFailure(scene.status, suite.allowFlaky)) {
    xml_node outcome = node.append_child(scene.status == Status::error ? "error" : "failure");
    setText(outcome, "type", statusName(scene.status));
    setText(outcome, "message", firstReason(scene));
    addBody(outcome, failureBody(suite, scene));
  }
  std::string text = outputText(suite, scene);
  if (!pictures.empty()) text += attachments(scene, pictures);
  if (!text.empty()) addBody(node.append_child("system-out"), text);
}

void setCounts(xml_node node, const SuiteResult& suite) {
  const auto errors = static_cast<long long>(countOf(suite, Status::error));
  const auto failed = static_cast<long long>(failures(suite).size()) - errors;
  node.append_attribute("name") = "simreel";
  node.append_attribute("tests") = static_cast<unsigned long long>(suite.scenes.size());
  node.append_attribute("failures") = failed;
  node.append_attribute("errors") = errors;
}

}  // namespace

std::string junitText(const SuiteResult& suite, const std::filesystem::path& pictures) {
  pugi::xml_document document;
  xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  xml_node root = document.append_child("testsuites");
  // Omits the "skipped" attribute. The schema of Jenkins' xUnit plugin allows it only on <testsuite>, and
  // rejects the file otherwise.
  setCounts(root, suite);
  setSeconds(root, suite.seconds);
  xml_node node = root.append_child("testsuite");
  setCounts(node, suite);
  node.append_attribute("skipped") = static_cast<long long>(countOf(suite, Status::xfail));
  setSeconds(node, suite.seconds);
  xml_node properties = node.append_child("properties");
  const auto property = [&](const char* name, const std::string& value) {
    if (value.empty() && suite.unit == "picture")
      return;  // The pictures of other programs were not drawn by a known device.
    xml_node entry = properties.append_child("property");
    setText(entry, "name", name);
    setText(entry, "value", value);
  };
  property("driver", suite.driver);
  property("processor", suite.processor);
  property("profile", suite.profile);
  property("fingerprint", suite.fingerprint);
  property("drawing", suite.drawing);
  property("version", suite.version);
  for (const SceneResult& scene : suite.scenes) addCase(node, suite, scene, pictures);
  std::string about;
  for (const Stale& stale : suite.stale)
    about += fmt::format("{}: {}: {}\n", stale.removed ? "removed" : "stale", stale.path, stale.message);
  for (const std::string& note : suite.notes) about += "note: " + note + "\n";
  if (!about.empty()) addBody(node.append_child("system-out"), about);
  std::ostringstream text;
  document.save(text, "  ", pugi::format_indent, pugi::encoding_utf8);
  return text.str();
}

}  // namespace simreel::golden

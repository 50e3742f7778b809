#include "golden/report/junit.hpp"

#include "source_folder.hpp"
#include "unit/frame/help.hpp"
#include "unit/golden/suite.hpp"

#include <cmath>
#include <cstdlib>
#include <pugixml.hpp>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::golden;
using frame::test::contains;

namespace {

/// Returns the first child of <testsuites>. The document must outlive it.
pugi::xml_node suiteOf(pugi::xml_document& document, const SuiteResult& suite) {
  const std::string text = junitText(suite);
  REQUIRE(document.load_string(text.c_str()));
  CHECK(text.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"));
  return document.child("testsuites").child("testsuite");
}

pugi::xml_node caseOf(pugi::xml_node suite, const char* name) {
  return suite.find_child_by_attribute("testcase", "name", name);
}

/// Validates the text against junit.xsd. Returns xmllint's messages, or an empty text if it is valid.
std::string lint(const std::string& text) {
  const frame::test::TemporaryFolder folder;
  writeFileAtomically(folder / "junit.xml", text);
  const std::string command =
      fmt::format("xmllint --noout --schema '{}/tests/unit/junit.xsd' '{}' > '{}' 2>&1", sourceFolder(),
                  (folder / "junit.xml").string(), (folder / "said").string());
  const int code = std::system(command.c_str());
  return code == 0 ? "" : "refused: " + readFile(folder / "said", "output");
}

}  // namespace

TEST_CASE("JUnit: totals and environment are written") {
  SuiteResult suite = golden::test::fullSuite();
  pugi::xml_document document;
  pugi::xml_node node = suiteOf(document, suite);
  for (const pugi::xml_node& totals : {node.parent(), node}) {
    CHECK(totals.attribute("name").value() == std::string("simreel"));
    CHECK(totals.attribute("tests").as_int() == 9);
    CHECK(totals.attribute("failures").as_int() == 5);
    CHECK(totals.attribute("errors").as_int() == 1);
    CHECK(totals.attribute("time").value() == std::string("6.250"));
  }
  CHECK(node.attribute("skipped").as_int() == 1);
  CHECK(node.select_nodes("testcase").size() == 9);
  CHECK(node.select_nodes("testcase/failure").size() == 5);
  const auto property = [&](const char* name) {
    return std::string(
        node.child("properties").find_child_by_attribute("name", name).attribute("value").value());
  };
  CHECK(property("driver") == suite.driver);
  CHECK(property("profile") == "llvmpipe-fma");
  CHECK(property("fingerprint") == "0123456789abcdef");
  CHECK(property("version") == "0.1.0");
}

TEST_CASE("JUnit: each status has its JUnit element") {
  pugi::xml_document document;
  const pugi::xml_node node = suiteOf(document, golden::test::fullSuite());
  const pugi::xml_node flag = caseOf(node, "flag");
  CHECK(flag.attribute("classname").value() == std::string("assets/scenes"));
  CHECK(flag.attribute("time").value() == std::string("2.125"));
  const pugi::xml_node failure = flag.child("failure");
  CHECK(failure.attribute("type").value() == std::string("fail"));
  CHECK(failure.attribute("message").value() == std::string("frame 60: 312 pixels differ"));
  CHECK(failure.text().get() ==
        std::string("frame 60: 312 pixels differ\nthe state differs from frame 60 on\n"
                    "frame 119: 700 pixels differ\nframe 60: energy of flag is 3.1, above 3\n"
                    "frame -2, step 3 of 16: flag\nframe 60 expected: images/flag/60-expected.png\n"
                    "frame 60 actual: images/flag/60-actual.png\n"
                    "frame 60 difference: images/flag/60-difference.png\n"
                    "frame 119 expected: images/flag/119-expected.png\n"
                    "frame 119 actual: images/flag/119-actual.png\n"
                    "frame 119 difference: images/flag/119-difference.png\n"
                    "To accept: simreel accept out/report.json\n"));
  const std::string out = flag.child("system-out").text().get();
  CHECK(contains(out, "note: no baseline of nvidia-ada\n"));
  CHECK(contains(out, "frame 119 actual: images/flag/119-actual.png\n"));
  for (const char* status : {"nondeterministic", "missing", "xpass", "flaky"})
    CHECK(caseOf(node, fmt::format("is-{}", status).c_str()).child("failure").attribute("type").value() ==
          std::string(status));
  CHECK(caseOf(node, "is-error").child("error").attribute("message").value() ==
        std::string("assets/scenes/is-error.json:3:4: unknown key"));
  CHECK(caseOf(node, "is-xfail").child("skipped").attribute("message").value() ==
        std::string("expected failure: issue 12: folds flicker"));
  for (const char* name : {"waves", "is-updated"}) CHECK(!caseOf(node, name).first_child());
}

TEST_CASE("JUnit: an allowed flaky scene passes with a note") {
  SuiteResult suite = golden::test::fullSuite();
  suite.allowFlaky = true;
  pugi::xml_document document;
  const pugi::xml_node node = suiteOf(document, suite);
  CHECK(node.attribute("failures").as_int() == 4);
  const pugi::xml_node flaky = caseOf(node, "is-flaky");
  CHECK(!flaky.child("failure"));
  CHECK(flaky.child("system-out").text().get() ==
        std::string("flaky: failed, then passed on attempt 2\nattempt 1: frame 9: 5 pixels differ\n"));
}

TEST_CASE("JUnit: characters forbidden in XML are replaced") {
  pugi::xml_document document;
  const pugi::xml_node node = suiteOf(document, golden::test::brokenSuite());
  const std::string text = junitText(golden::test::brokenSuite());
  for (const char* forbidden : {"\x1B", "\x01", "\xFF", "&#x1B;", "&#27;", "&#1;", "&#x1;"})
    CHECK(!contains(text, forbidden));
  const pugi::xml_node flag = node.first_child().next_sibling().next_sibling();
  CHECK(contains(flag.attribute("name").value(), "bad \xEF\xBF\xBD\xEF\xBF\xBD "));
  CHECK(contains(flag.child("failure").text().get(), "</script> ]]> & <b>"));
  CHECK(contains(flag.child("failure").text().get(), "caf\xC3\xA9 \xE2\x82\xAC"));
}

TEST_CASE("JUnit: the file is valid against the common JUnit schema") {
  if (std::system("xmllint --version > /dev/null 2>&1") != 0) {
    MESSAGE("skipped: xmllint is not installed (libxml2-utils)");
    return;
  }
  SuiteResult strange = golden::test::fullSuite();
  strange.seconds = std::nan("");
  strange.scenes[0].seconds = -1;
  strange.scenes[0].file = "";
  strange.scenes[1].messages = {"", "\n"};
  SuiteResult allowed = golden::test::fullSuite();
  allowed.allowFlaky = true;
  for (const SuiteResult& suite : {golden::test::fullSuite(), golden::test::oddSuite(),
                                   golden::test::brokenSuite(), SuiteResult{}, strange, allowed})
    CHECK(lint(junitText(suite)) == "");
  // Checks that the schema rejects invalid text.
  const std::string good = junitText(golden::test::fullSuite());
  const auto damaged = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    REQUIRE(contains(text, from));
    return lint(text.replace(text.find(from), from.size(), to));
  };
  CHECK(contains(damaged("time=\"6.250\"", "time=\"6e2\""), "time"));
  CHECK(contains(damaged("errors=\"1\"", "errors=\"1\" skipped=\"1\""), "skipped"));
  CHECK(contains(damaged("type=\"fail\"", ""), "type"));
  CHECK(contains(damaged("<properties>", "<properties><b/>"), "b"));
}

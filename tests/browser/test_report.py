"""Tests the HTML report in a browser: every control in Chromium, loaded from disk, and a report of 500 failures in
Chromium and in Firefox. Skipped (exit code 77) without Chromium or Selenium."""
import importlib.util
import shutil
import sys
import unittest


def missing():
    packages = {"chromium": shutil.which("chromium"), "chromium-driver": shutil.which("chromedriver"),
                "python3-selenium": importlib.util.find_spec("selenium")}
    return [name for name, found in packages.items() if not found]


def load_tests(loader, *_):
    names = ("list_tests", "picture_tests", "frame_tests", "page_tests", "many_tests")
    return unittest.TestSuite(loader.loadTestsFromName(name) for name in names)


if __name__ == "__main__":
    if missing():
        print(f"skipped: {', '.join(missing())} not installed (tools/setup installs what the tests need)")
        sys.exit(77)
    unittest.main(verbosity=2)

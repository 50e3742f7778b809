"""A headless Firefox, controlled by its own remote protocol (Marionette), because Debian has no geckodriver. A request
is "length:[0, number, command, parameters]", an answer "length:[1, number, error, result]"."""
import base64
import json
import pathlib
import shutil
import socket
import subprocess
import tempfile
import time

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
PREFERENCES = {"marionette.port": 0, "browser.shell.checkDefaultBrowser": False, "datareporting.policy.dataSubmissionEnabled": False,
               "app.update.enabled": False, "browser.startup.page": 0, "toolkit.cosmeticAnimations.enabled": False,
               "layout.css.devPixelsPerPx": "1.0", "browser.aboutwelcome.enabled": False}


class Firefox:
    def __init__(self):
        self.profile = tempfile.TemporaryDirectory(prefix="simreel-firefox-")
        lines = [f"user_pref({json.dumps(name)}, {json.dumps(value)});" for name, value in PREFERENCES.items()]
        pathlib.Path(self.profile.name, "user.js").write_text("\n".join(lines))
        self.process = subprocess.Popen([FIREFOX, "--headless", "--marionette", "--no-remote", "--remote-allow-system-access",
                                         "--profile", self.profile.name],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            self.number = 0
            self.socket = socket.create_connection(("127.0.0.1", self.port()), timeout=600)
            self.receive()  # reads the greeting message of Firefox, which is not needed
            self.command("WebDriver:NewSession", capabilities={"alwaysMatch": {"acceptInsecureCerts": True}})
        except BaseException:
            self.quit()
            raise

    def port(self):
        """Returns the port that Firefox chose and wrote into its profile."""
        file = pathlib.Path(self.profile.name, "MarionetteActivePort")
        end = time.monotonic() + 600
        while time.monotonic() < end:
            if self.process.poll() is not None:
                raise RuntimeError(f"Firefox ended with {self.process.returncode}")
            if file.exists() and (text := file.read_text().strip()):
                return int(text)
            time.sleep(0.05)
        raise RuntimeError("Firefox does not listen after 600 s")

    def quit(self):
        if hasattr(self, "socket"):
            self.socket.close()
        self.process.terminate()
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.profile.cleanup()

    def receive(self):
        length = b""
        while not length.endswith(b":"):
            length += self.socket.recv(1)
        wanted, text = int(length[:-1]), b""
        while len(text) < wanted:
            text += self.socket.recv(wanted - len(text))
        return json.loads(text)

    def command(self, name, **parameters):
        self.number += 1
        text = json.dumps([0, self.number, name, parameters]).encode()
        self.socket.sendall(b"%d:%s" % (len(text), text))
        _, _, error, result = self.receive()
        if error:
            raise RuntimeError(f"{name}: {error['error']}: {error['message']}")
        return result.get("value") if isinstance(result, dict) else result

    def size(self, width, height):
        self.command("WebDriver:SetWindowRect", width=width, height=height)

    def open(self, page, link=""):
        self.command("WebDriver:Navigate", url="about:blank")
        self.command("WebDriver:Navigate", url=pathlib.Path(page).as_uri() + link)

    def value(self, expression):
        """Evaluates an expression in a script element, because only the page's own scripts see names declared with
        const."""
        text = f"document.documentElement.dataset.answer = JSON.stringify({expression}) ?? 'null'"
        script = ("const made = document.createElement('script'), root = document.documentElement; delete root.dataset.answer;"
                  "made.textContent = arguments[0]; document.head.append(made); made.remove();"
                  "const answer = root.dataset.answer; delete root.dataset.answer; return answer ?? null;")
        answer = self.command("WebDriver:ExecuteScript", script=script, args=[text])
        if answer is None:
            raise RuntimeError(f"no answer to {expression}")
        return json.loads(answer)

    def run(self, script, *arguments):
        """Runs a script from outside the page, for pages whose policy forbids inline scripts; `page` holds the page's
        own objects."""
        return self.command("WebDriver:ExecuteScript", script="const page = window.wrappedJSObject ?? window; " + script, args=arguments)

    def complaints(self, address):
        """Returns the console's messages about pages at an address: errors of scripts, styles and policy, and warnings
        and errors written by the pages."""
        script = """const own = (text) => String(text ?? "").startsWith(arguments[0]);
            const errors = Services.console.getMessageArray().filter((m) => m instanceof Ci.nsIScriptError && own(m.sourceName));
            const storage = Cc["@mozilla.org/consoleAPI-storage;1"].getService(Ci.nsIConsoleAPIStorage);
            const written = storage.getEvents().filter((e) => ["warn", "error", "assert"].includes(e.level) && own(e.filename));
            return [...errors.map((m) => m.errorMessage), ...written.map((e) => `${e.level}: ${[...e.arguments].join(" ")}`)];"""
        self.command("Marionette:SetContext", value="chrome")
        try:
            return self.command("WebDriver:ExecuteScript", script=script, args=[address])
        finally:
            self.command("Marionette:SetContext", value="content")

    def click(self, selector):
        found = self.command("WebDriver:FindElement", using="css selector", value=selector)
        self.command("WebDriver:ElementClick", id=next(iter(found.values())))

    def picture_of(self, selector):
        """Returns a PNG of an element as displayed."""
        found = self.command("WebDriver:FindElement", using="css selector", value=selector)
        return base64.b64decode(self.command("WebDriver:TakeScreenshot", id=next(iter(found.values())), full=False))

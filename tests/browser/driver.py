"""A headless Chromium that opens a report, and functions that read the page."""
import json
import pathlib
import time

from selenium import webdriver
from selenium.webdriver import ActionChains, Keys
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By


class Browser:
    def __init__(self, chromium, chromedriver, requests=True):
        """`requests`: True to record the page's requests; for a WebSocket this records every message."""
        options = Options()
        options.binary_location = chromium
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                         "--force-device-scale-factor=1", "--no-first-run"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"} | ({"performance": "ALL"} if requests else {}))
        self.driver = webdriver.Chrome(service=Service(chromedriver), options=options)
        self.driver.set_script_timeout(1200)
        self.size(1280, 800)

    def quit(self):
        self.driver.quit()

    def size(self, width, height):
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                     mobile=width < 600)

    def command(self, name, **arguments):
        return self.driver.execute_cdp_cmd(name, arguments)

    def dark(self, on):
        features = [{"name": "prefers-color-scheme", "value": "dark" if on else "light"}]
        self.command("Emulation.setEmulatedMedia", features=features)

    def open(self, page, link=""):
        """Loads the page afresh, instead of only changing the hash."""
        self.driver.get("about:blank")
        self.driver.get((page if isinstance(page, str) else pathlib.Path(page).as_uri()) + link)
        self.settle()

    def settle(self):
        """Waits until the pictures of the page are loaded and the next repaint is done."""
        self.run("""const done = arguments[0];
            const wait = () => [...document.querySelectorAll('#panes img')].every((i) => i.complete) ?
                requestAnimationFrame(() => requestAnimationFrame(() => done(0))) : setTimeout(wait, 10);
            wait();""", wait=True)

    def run(self, script, *arguments, wait=False):
        return (self.driver.execute_async_script if wait else self.driver.execute_script)(script, *arguments)

    def value(self, expression):
        return self.run("return " + expression)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def one(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def text(self, selector):
        return self.value(f"document.querySelector({json.dumps(selector)}).textContent")

    def texts(self, selector):
        return self.value(f"[...document.querySelectorAll({json.dumps(selector)})].map((e) => e.textContent)")

    def style(self, selector, name):
        return self.run("return getComputedStyle(document.querySelector(arguments[0]))[arguments[1]]", selector, name)

    def picture_widths(self):
        return self.value("[...document.querySelectorAll('#panes img')].map((image) => image.naturalWidth)")

    def visible(self, selector):
        return [element for element in self.all(selector) if element.is_displayed()]

    def click(self, selector):
        self.one(selector).click()
        self.settle()

    def keys(self, *keys):
        for key in keys:
            ActionChains(self.driver).send_keys(key).perform()
        self.settle()

    def keys_with_shift(self, key):
        ActionChains(self.driver).key_down(Keys.SHIFT).send_keys(key).key_up(Keys.SHIFT).perform()
        self.settle()

    def box(self, selector):
        return self.value(f"document.querySelector({json.dumps(selector)}).getBoundingClientRect().toJSON()")

    def pointer(self, kind, x, y, **more):
        self.command("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def move(self, x, y):
        self.pointer("mouseMoved", x, y)

    def drag(self, x, y, to_x, to_y):
        self.move(x, y)
        self.pointer("mousePressed", x, y, button="left", buttons=1, clickCount=1)
        for i in range(1, 5):
            self.pointer("mouseMoved", x + (to_x - x) * i / 4, y + (to_y - y) * i / 4, button="left", buttons=1)
        self.pointer("mouseReleased", to_x, to_y, button="left", clickCount=1)
        self.settle()

    def wheel(self, x, y, delta):
        self.pointer("mouseWheel", x, y, deltaX=0, deltaY=delta)
        self.settle()

    def until(self, expression, seconds=600):
        """Waits for an asynchronous change and returns the expression's last value. The page itself evaluates the
        expression repeatedly, because each query from outside involves three processes."""
        return self.run("""const done = arguments[1], end = performance.now() + arguments[0];
            const look = () => { const value = (%s); return value || performance.now() > end ? done(value) : setTimeout(look, 15); };
            look();""" % expression, 1000 * seconds, wait=True)

    def transform(self, pane=0):
        """Returns scale and offset of the first picture of a pane."""
        matrix = self.style(f".pane:nth-child({pane + 1}) img", "transform")
        numbers = [float(n) for n in matrix[len("matrix("):-1].split(",")]
        return numbers[0], numbers[4], numbers[5]

    def picture_at(self, x, y, pane=0):
        """Returns the picture coordinates shown at a point of the screen."""
        scale, left, top = self.transform(pane)
        box = self.box(f".pane:nth-child({pane + 1})")
        return (x - box["x"] - left) / scale, (y - box["y"] - top) / scale

    def problems(self):
        """Returns the console's messages since the last call."""
        entries = self.driver.get_log("browser")
        return [entry["message"] for entry in entries if entry["level"] in ("SEVERE", "WARNING")]

    def requests(self):
        """Returns the requested addresses since the last call."""
        events = [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]
        asked = [event["params"]["request"] for event in events if event["method"] == "Network.requestWillBeSent"]
        return [request["url"] for request in asked]


__all__ = ["Browser", "Keys"]

"""A headless Chromium of Debian, and what the tests of pages ask it."""
import base64
import json
import pathlib
import time

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By

HERE = pathlib.Path(__file__).resolve().parent
CHROMIUM, DRIVER = "/usr/bin/chromium", "/usr/bin/chromedriver"
HIGH = 900  # pixels of the window


class Browser:
    def __init__(self):
        options = webdriver.ChromeOptions()
        options.binary_location = CHROMIUM
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
                         "--disable-background-networking", "--hide-scrollbars"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(service=Service(DRIVER), options=options)
        self.driver.set_page_load_timeout(120)
        self.audit_script = (HERE / "audit.js").read_text(encoding="utf-8")

    def close(self):
        self.driver.quit()

    def command(self, name, **parameters):
        return self.driver.execute_cdp_cmd(name, parameters)

    def width(self, pixels):
        self.command("Emulation.setDeviceMetricsOverride", width=pixels, height=HIGH, deviceScaleFactor=1, mobile=False)

    def media(self, kind="screen", scheme="light"):
        self.command("Emulation.setEmulatedMedia", media=kind, features=[{"name": "prefers-color-scheme", "value": scheme}])

    def open(self, page):
        """Opens a file and returns the milliseconds from the start of the navigation to the end of its load event."""
        self.driver.get_log("performance")
        self.driver.get_log("browser")
        self.driver.get(pathlib.Path(page).as_uri())
        return self.driver.execute_script("return performance.getEntriesByType('navigation')[0].loadEventEnd")

    def load_all_pictures(self):
        """Pictures below the window load when one scrolls to them; here all do."""
        self.driver.execute_script("for (const image of document.images) image.loading = 'eager'")
        for _ in range(600):
            if self.driver.execute_script("return [...document.images].every((image) => image.complete)"):
                return
            time.sleep(0.05)
        raise AssertionError("pictures do not come to their end")

    def requests(self):
        """Addresses the page asked for since it was opened."""
        messages = [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]
        return [m["params"]["request"]["url"] for m in messages if m["method"] == "Network.requestWillBeSent"]

    def complaints(self):
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def audit(self):
        """What is wrong with the page as it stands, one line each."""
        return self.driver.execute_script(self.audit_script + "\nreturn audit();")

    def overflow(self):
        """Elements that reach beyond the page's width, the page itself included."""
        return self.driver.execute_script(self.audit_script + "\nreturn overflow();")

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def find_all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def screenshot(self, path):
        """The whole page, not the window alone."""
        size = self.command("Page.getLayoutMetrics")["cssContentSize"]
        shot = self.command("Page.captureScreenshot", captureBeyondViewport=True,
                            clip={"x": 0, "y": 0, "width": size["width"], "height": min(size["height"], 16000), "scale": 1})
        path.write_bytes(base64.b64decode(shot["data"]))

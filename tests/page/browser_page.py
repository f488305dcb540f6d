"""A page in headless Chromium, used as a person would."""

import base64
import unittest

from selenium import webdriver
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

LONGEST_S = 60


def browser(*options, calm=True):
    settings = webdriver.ChromeOptions()
    settings.binary_location = "/usr/bin/chromium"
    for option in ("--headless=new", "--no-sandbox", "--window-size=1200,900",
                   "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                   *(["--force-prefers-reduced-motion"] if calm else []), *options):
        settings.add_argument(option)
    settings.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    service = webdriver.chrome.service.Service("/usr/bin/chromedriver")
    return webdriver.Chrome(service=service, options=settings)


class OpenedPage(unittest.TestCase):
    """A page that has been opened and says that it is ready."""

    page = None      # its file
    pictures = None  # a folder for pictures of what was seen
    options = ()
    calm = True

    def setUp(self):
        self.browser = browser(*self.options, calm=self.calm)
        self.addCleanup(self.browser.quit)
        self.browser.get(self.page.as_uri())
        self.wait_for(lambda: self.body_is_ready(), "the page did not get ready")

    def body_is_ready(self):
        return self.script("return document.body.dataset.ready !== undefined")

    def script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def wait_for(self, condition, complaint):
        WebDriverWait(self.browser, LONGEST_S, poll_frequency=0.05).until(
            lambda _: condition(), f"{complaint}; status: {self.status()}")

    def find(self, name):
        return self.browser.find_element(By.ID, name)

    def status(self):
        return self.find("status").text

    def press(self, *keys):
        ActionChains(self.browser).send_keys(*keys).perform()

    def drop(self, name, content):
        """A file of this name and content, dropped on the page."""
        self.script("""
            const bytes = Uint8Array.from(atob(arguments[1]), letter => letter.charCodeAt(0));
            const data = new DataTransfer();
            data.items.add(new File([bytes], arguments[0]));
            document.body.dispatchEvent(
                new DragEvent('drop', {dataTransfer: data, bubbles: true, cancelable: true}));""",
                    name, base64.b64encode(content).decode())

    def picture(self, name):
        self.pictures.mkdir(parents=True, exist_ok=True)
        self.browser.save_screenshot(str(self.pictures / f"{name}.png"))

    def set_screen(self, width, height):
        """A phone's, most likely."""
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 2, "mobile": True})

    def touch(self, kind, *points):
        self.browser.execute_cdp_cmd("Input.dispatchTouchEvent", {
            "type": kind, "touchPoints": [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)]})

    def blocked_by_policy(self):
        """What forbids the page to load something; 'allowed' where nothing does."""
        return self.browser.execute_async_script("""
            const done = arguments[0];
            addEventListener('securitypolicyviolation', event => done(event.effectiveDirective));
            fetch('https://example.org/').finally(() => setTimeout(() => done('allowed'), 500));""")

    def asked_of_others(self):
        asked = [entry["message"] for entry in self.browser.get_log("performance")
                 if "Network.requestWillBeSent" in entry["message"]]
        return [message for message in asked if '"url":"http' in message]

    def check_controls(self):
        """Each that is shown has a name and room for a finger."""
        controls = self.browser.find_elements(
            By.CSS_SELECTOR, "button, select, label, input[type=range], input[type=number]")
        for control in controls:
            if not control.is_displayed():
                continue
            label = self.script("return arguments[0].labels?.[0]?.textContent", control)
            name = control.get_attribute("aria-label") or control.text or label
            self.assertTrue(name, control.get_attribute("id"))
            self.assertGreaterEqual(round(control.rect["height"]), 44, name)

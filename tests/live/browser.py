"""A real browser on a page of `mien live`: Debian's chromium without a graphics card, so that all machines draw alike."""
import subprocess
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

WAIT_S = 150  # on a busy machine


def start_live(program, file, *options):
    """The running program and its page's address."""
    process = subprocess.Popen([program, "live", file, *options], stdout=subprocess.PIPE, text=True)
    return process, process.stdout.readline().strip()


class Page:
    wait_s = WAIT_S

    def __init__(self, address, width=1280, height=720, is_dark=False):
        options = Options()
        options.binary_location = "/usr/bin/chromium"
        for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
                         "--enable-unsafe-swiftshader", "--force-color-profile=srgb", f"--window-size={width},{height}"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        self.driver.set_script_timeout(WAIT_S)
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                    {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        scheme = "dark" if is_dark else "light"
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                    {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
        self.driver.get(address)

    def run(self, script, *values):
        """What the script returns."""
        return self.driver.execute_script(script, *values)

    def find(self, expression):
        return self.run("return " + expression)

    def wait_for(self, script):
        """What the script's promise comes to."""
        return self.driver.execute_async_script(
            "const done = arguments[arguments.length - 1];"
            f"(async () => {{ {script} }})().then(done, (error) => done('ERROR ' + error))")

    def until(self, expression, most_s=None):
        """Whether the expression becomes true in time."""
        end_s = time.monotonic() + (most_s or self.wait_s)
        while time.monotonic() < end_s:
            if self.find(expression):
                return True
            time.sleep(0.05)
        return False

    def is_ready(self):
        return self.until("Boolean(window.mienLive && mienLive.view && mienLive.view.now)")

    def act(self):
        return ActionChains(self.driver)

    def press(self, key, control=False):
        actions = self.act()
        if control:
            actions.key_down(Keys.CONTROL)
        actions.send_keys(key)
        if control:
            actions.key_up(Keys.CONTROL)
        actions.perform()

    def list_accessible(self):
        """What a screen reader is given: {role, name, value and the properties} of each node, with what the node is in the page."""
        nodes = []
        for node in self.driver.execute_cdp_cmd("Accessibility.getFullAXTree", {})["nodes"]:
            if node.get("ignored"):
                continue
            told = {"role": node["role"]["value"], "name": node.get("name", {}).get("value", "").strip(),
                    "value": node.get("value", {}).get("value")}
            for entry in node.get("properties", []):
                told[entry["name"]] = entry["value"].get("value")
            if told.get("focusable") and told["role"] == "generic":  # those that only scripts focus are no controls
                page_node = self.driver.execute_cdp_cmd("DOM.describeNode", {"backendNodeId": node["backendDOMNodeId"]})["node"]
                told["focusable"] = "-1" not in page_node["attributes"]
            nodes.append(told)
        return nodes

    def list_errors(self):
        """What the browser complained of."""
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] == "SEVERE"]

    def close(self):
        self.driver.quit()

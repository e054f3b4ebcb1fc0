# SPDX-License-Identifier: MIT
"""A headless Chromium by the WebDriver protocol (W3C WebDriver, level 2)."""
import http.client
import json
import re
import shutil
import subprocess
import tempfile
import time

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # the protocol's name for a reference to an element
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync", "--window-size=1400,1000"]


def check(holds, what):
    if not holds:
        raise AssertionError(what)


# ---- what a reader does


class Browser:
    """One session; ends with the block it was opened in."""

    def __init__(self, driver, chromium):
        self.profile = tempfile.mkdtemp(prefix="lixel-browser-")
        self.process = subprocess.Popen([driver, "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        text=True)
        try:
            self.port = self.read_port()
            self.session = self.open_session(chromium)
        except BaseException:
            self.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.call("DELETE", "")
        finally:
            self.close()

    def close(self):
        self.process.terminate()
        self.process.wait(timeout=20)
        self.process.stdout.close()
        shutil.rmtree(self.profile, ignore_errors=True)

    def read_port(self):
        said = ""
        for line in self.process.stdout:
            said += line
            if found := re.search(r"successfully on port (\d+)", line):
                return int(found.group(1))
        raise RuntimeError("the driver did not start: " + said)

    def open_session(self, chromium):
        options = {"binary": chromium, "args": [*FLAGS, "--user-data-dir=" + self.profile]}
        wanted = {"browserName": "chrome", "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}
        return self.send("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})["sessionId"]

    def send(self, method, path, body=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        text = None if body is None else json.dumps(body)
        connection.request(method, path, text, {"Content-Type": "application/json"})
        value = json.loads(connection.getresponse().read())["value"]
        connection.close()
        if isinstance(value, dict) and "error" in value:
            raise RuntimeError(f"{method} {path}: {value['error']}: {value['message']}")
        return value

    def call(self, method, path, body=None):
        return self.send(method, f"/session/{self.session}{path}", body)

    def run(self, script, *arguments):
        return self.call("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def find(self, css):
        return self.call("POST", "/element", {"using": "css selector", "value": css})

    def click(self, css):
        self.run("arguments[0].scrollIntoView({block: 'center'})", self.find(css))
        self.call("POST", f"/element/{self.find(css)[ELEMENT]}/click", {})

    def type(self, css, keys):
        self.call("POST", f"/element/{self.find(css)[ELEMENT]}/value", {"text": keys})

    def act(self, *sources):
        self.call("POST", "/actions", {"actions": list(sources)})

    def drag(self, css, dx, dy):
        """From the element's centre, with the mouse."""
        self.run("arguments[0].scrollIntoView({block: 'center'})", self.find(css))
        x, y = self.run("const b = arguments[0].getBoundingClientRect();"
                        "return [b.x + b.width / 2, b.y + b.height / 2].map(Math.round)", self.find(css))
        self.act({"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": [
            {"type": "pointerMove", "duration": 0, "x": x, "y": y},
            {"type": "pointerDown", "button": 0},
            {"type": "pointerMove", "duration": 50, "x": x + dx, "y": y + dy},
            {"type": "pointerUp", "button": 0}]})

    def wheel(self, css, x, y, delta):
        self.act({"type": "wheel", "id": "wheel", "actions": [
            {"type": "scroll", "origin": self.find(css), "x": x, "y": y, "deltaX": 0, "deltaY": delta, "duration": 0}]})

    def wait_for(self, what, script):
        until = time.monotonic() + 20
        while not self.run(script):
            check(time.monotonic() < until, what)
            time.sleep(0.05)

    def devtools(self, command, **parameters):
        return self.call("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def look_like(self, width, height, theme):
        """A window of that size, in CSS pixels."""
        self.devtools("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                      mobile=width < 600)
        self.devtools("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": theme}])

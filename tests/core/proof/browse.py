#!/usr/bin/env python3
"""Opens a proof page in headless Chromium, uses it, and prints what happened as JSON.

    browse.py PAGE.html KEY [KEY …]

The keys name layers. Needs chromedriver. All requests of the browser go to a proxy that counts them.
"""
import base64
import hashlib
import json
import socket
import subprocess
import sys
import threading
import time
import urllib.request


# What the browser itself asks for, the second after about a minute, whatever its options say.
BROWSERS_OWN = (".google.com:443", "update.googleapis.com")


class CountingProxy:
    """Accepts connections, keeps their first lines and answers nothing."""

    def __init__(self):
        self.lines = []
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.port = self.socket.getsockname()[1]
        threading.Thread(target=self.accept, daemon=True).start()

    def accept(self):
        while True:
            connection, _ = self.socket.accept()
            connection.settimeout(5)
            self.lines.append(connection.recv(4096).split(b"\r\n")[0].decode("latin-1"))
            connection.close()


class Browser:
    def __init__(self, proxy):
        self.port = self.free_port()
        self.driver = subprocess.Popen(
            ["chromedriver", f"--port={self.port}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        arguments = [
            "--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
            "--enable-unsafe-swiftshader", "--hide-scrollbars", "--window-size=1280,800",
            "--no-first-run", "--disable-component-update", "--disable-background-networking",
            "--disable-features=OptimizationHints,MediaRouter",
            f"--proxy-server=127.0.0.1:{proxy.port}", "--proxy-bypass-list=<-loopback>",
        ]
        for _ in range(100):
            try:
                self.ask("GET", "/status")
                break
            except OSError:
                time.sleep(0.05)
        options = {
            "goog:chromeOptions": {"args": arguments},
            "goog:loggingPrefs": {"browser": "ALL"},
        }
        value = self.ask("POST", "/session", {"capabilities": {"alwaysMatch": options}})
        self.session = f"/session/{value['sessionId']}"

    @staticmethod
    def free_port():
        with socket.create_server(("127.0.0.1", 0)) as found:
            return found.getsockname()[1]

    def ask(self, method, path, body=None):
        request = urllib.request.Request(
            f"http://127.0.0.1:{self.port}{path}",
            method=method,
            data=None if body is None else json.dumps(body).encode(),
            headers={"Content-Type": "application/json"},
        )
        return json.load(urllib.request.urlopen(request, timeout=60))["value"]

    def post(self, path, body):
        return self.ask("POST", self.session + path, body)

    def script(self, text):
        return self.post("/execute/sync", {"script": text, "args": []})

    def command(self, name, parameters):
        return self.post("/goog/cdp/execute", {"cmd": name, "params": parameters})

    def wait_for(self, text):
        for _ in range(200):
            if self.script(f"return {text}"):
                return True
            time.sleep(0.05)
        return False

    def canvas(self):
        """Returns a hash of the drawn part."""
        time.sleep(0.3)
        element = self.post("/element", {"using": "css selector", "value": "canvas"})
        picture = self.ask("GET", f"{self.session}/element/{list(element.values())[0]}/screenshot")
        return hashlib.sha256(base64.b64decode(picture)).hexdigest()

    def key(self, key):
        self.script("document.querySelector('canvas').focus()")
        for kind in ("keyDown", "keyUp"):
            self.command("Input.dispatchKeyEvent", {"type": kind, "key": key, "code": key})

    def drag(self, touch):
        box = self.script(
            "const b = document.querySelector('canvas').getBoundingClientRect();"
            "return [b.x + b.width / 2, b.y + b.height / 2]"
        )
        for step, kind in enumerate(["Start", "Move", "Move", "End"]):
            x, y = box[0] + 30 * step, box[1] + 10 * step
            if touch:
                points = [] if kind == "End" else [{"x": x, "y": y}]
                self.command("Input.dispatchTouchEvent", {"type": f"touch{kind}", "touchPoints": points})
            else:
                mouse = {"Start": "mousePressed", "Move": "mouseMoved", "End": "mouseReleased"}[kind]
                self.command(
                    "Input.dispatchMouseEvent",
                    {"type": mouse, "x": x, "y": y, "button": "left", "buttons": 1, "clickCount": 1},
                )

    def close(self):
        try:
            self.ask("DELETE", self.session)
        finally:
            self.driver.terminate()
            self.driver.wait()


def main():
    page, keys = sys.argv[1], sys.argv[2:]
    proxy = CountingProxy()
    browser = Browser(proxy)
    found = {}
    try:
        browser.post("/url", {"url": "data:text/html,<img src='http://control.invalid/x'>"})
        time.sleep(0.3)
        found["controlRequests"] = len([line for line in proxy.lines if "control.invalid" in line])
        before = len(proxy.lines)
        browser.post("/url", {"url": f"file://{page}"})
        browser.wait_for("document.documentElement.dataset.state")
        found["state"] = browser.script("return document.documentElement.dataset.state")
        found["canvases"] = {}
        for key in keys:
            browser.script(f"document.querySelector('input[value=\"{key}\"]').click()")
            browser.wait_for(f"document.documentElement.dataset.layer === '{key}'")
            found["canvases"][key] = browser.canvas()
        still = found["canvases"][keys[-1]]
        for name, act in (
            ("key", lambda: browser.key("ArrowLeft")),
            ("mouse", lambda: browser.drag(False)),
            ("finger", lambda: browser.drag(True)),
        ):
            act()
            turned = browser.canvas()
            found[f"{name}Turns"] = turned != still
            still = turned
        background = "return getComputedStyle(document.body).backgroundColor"
        found["light"], found["dark"] = [
            (
                browser.command(
                    "Emulation.setEmulatedMedia",
                    {"features": [{"name": "prefers-color-scheme", "value": scheme}]},
                ),
                browser.script(background),
            )[1]
            for scheme in ("light", "dark")
        ]
        browser.command(
            "Emulation.setDeviceMetricsOverride",
            {"width": 360, "height": 740, "deviceScaleFactor": 2, "mobile": True},
        )
        browser.post("/refresh", {})
        browser.wait_for("document.documentElement.dataset.state")
        found["phoneWidth"] = browser.script("return document.documentElement.scrollWidth")
        found["injected"] = browser.script("return window.injected === true")
        found["resources"] = browser.script(
            "return performance.getEntriesByType('resource').map((entry) => entry.name.slice(0, 5))"
        )
        log = browser.post("/se/log", {"type": "browser"})
        found["errors"] = [entry["message"] for entry in log if entry["level"] == "SEVERE"
                           and "control.invalid" not in entry["message"]]
        # Chromium itself asks its maker, whatever the page is.
        found["requests"] = [
            line for line in proxy.lines[before:] if not any(own in line for own in BROWSERS_OWN)
        ]
    finally:
        browser.close()
    print(json.dumps(found))


main()

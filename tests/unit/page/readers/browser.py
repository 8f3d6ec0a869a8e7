"""Chromium without a window, over the pipe of its DevTools protocol; Python's standard library alone."""
import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

PROGRAM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
FLAGS = ["--headless=new", "--no-sandbox", "--disable-gpu-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--force-color-profile=srgb", "--hide-scrollbars", "--no-first-run",
         "--disable-extensions", "--disable-background-networking", "--remote-debugging-pipe"]


class Browser:
    """One page of one browser. `said` has what the page wrote to its console, and what it threw."""

    def __init__(self, url, width=1280, height=800, ratio=1, touch=False, before="",
                 ready="document.body?.dataset.ready === 'yes'"):
        self.home = tempfile.mkdtemp(prefix="frostfill-browser-")
        to_browser, self.to = os.pipe()
        self.source, from_browser = os.pipe()

        def connect():  # the browser reads from 3 and writes to 4
            high_in, high_out = os.dup(to_browser), os.dup(from_browser)
            os.dup2(high_in, 3)
            os.dup2(high_out, 4)

        self.process = subprocess.Popen([PROGRAM, *FLAGS, f"--user-data-dir={self.home}", "about:blank"],
                                        preexec_fn=connect, close_fds=False,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.waiting, self.number, self.session, self.said = b"", 0, None, []
        target = next(each for each in self.call("Target.getTargets")["targetInfos"] if each["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ["Page", "Runtime", "Log", "Network"]:
            self.call(f"{domain}.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=ratio,
                  mobile=touch)
        if touch:
            self.call("Emulation.setTouchEmulationEnabled", enabled=True)
        if before:
            self.call("Page.addScriptToEvaluateOnNewDocument", source=before)
        self.call("Page.navigate", url=url)
        self.until(ready)

    def __enter__(self):
        return self

    def __exit__(self, *what):
        os.close(self.to)  # then it ends by itself
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.source)
        shutil.rmtree(self.home, ignore_errors=True)

    def call(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.to, data):]
        end = time.monotonic() + 120
        while True:
            answer = self.receive(end)
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def receive(self, end):
        """The next message. Keeps what the page says."""
        while b"\0" not in self.waiting:
            if not select.select([self.source], [], [], max(0, end - time.monotonic()))[0]:
                raise TimeoutError("the browser does not answer")
            read = os.read(self.source, 1 << 16)
            if not read:
                raise EOFError("the browser has ended")
            self.waiting += read
        line, self.waiting = self.waiting.split(b"\0", 1)
        message = json.loads(line)
        facts = message.get("params", {})
        if message.get("method") == "Runtime.exceptionThrown":
            self.said.append(json.dumps(facts["exceptionDetails"]))
        if message.get("method") == "Runtime.consoleAPICalled":
            self.said.append(json.dumps(facts["args"]))
        if message.get("method") == "Log.entryAdded":
            self.said.append(facts["entry"]["text"])
        if message.get("method") == "Network.requestWillBeSent":
            self.said.append("asks for " + facts["request"]["url"][:80])
        return message

    def value(self, expression):
        """Of JavaScript in the page; waits for promises."""
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{expression}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def until(self, expression, seconds=90):
        end = time.monotonic() + seconds
        while not self.value(expression):
            if time.monotonic() > end:
                raise TimeoutError(f"never so: {expression}; the page said {self.said}; "
                                   f"notice: {self.value('document.getElementById(`notice`)?.textContent')}")
            time.sleep(0.05)

    def settle(self):
        """Until what was asked for is drawn."""
        self.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(1))))")

    def go_to(self, words):
        """Changes the part after # of the address."""
        self.value(f"location.hash = {json.dumps(words)}; 1")
        self.settle()
        self.settle()

    def screenshot(self):
        """As PNG."""
        self.settle()
        return base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])

    def key(self, key, code=None, text=None, modifiers=0):
        press = {"key": key, "code": code or key, "modifiers": modifiers}
        self.call("Input.dispatchKeyEvent", type="keyDown", **press, **({"text": text} if text else {}))
        self.call("Input.dispatchKeyEvent", type="keyUp", **press)
        self.settle()

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def drag(self, x, y, dx, dy, button="left"):
        buttons = {"left": 1, "right": 2}[button]
        self.mouse("mousePressed", x, y, button=button, buttons=buttons, clickCount=1)
        for i in range(1, 5):
            self.mouse("mouseMoved", x + dx * i / 4, y + dy * i / 4, button=button, buttons=buttons)
        self.mouse("mouseReleased", x + dx, y + dy, button=button, buttons=0, clickCount=1)
        self.settle()

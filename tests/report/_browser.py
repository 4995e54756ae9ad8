# SPDX-License-Identifier: GPL-3.0-or-later
"""Headless Chromium driven over its DevTools pipe: opens pages, evaluates, presses keys, takes screenshots."""

import base64
import json
import os
import select
import shutil
import struct
import subprocess
import tempfile
import time
import zlib

COMMANDS = ("chromium", "chromium-browser", "google-chrome", "chrome")


def find():
    """The browser; None where there is none."""
    return next((path for path in map(shutil.which, COMMANDS) if path), None)


class Browser:
    """One browser with one tab. What a page logs as an error or a warning, or throws, is in `problems`; what it asks of
    the network, in `requests`."""

    def __init__(self, command, webgl=True):
        self.profile = tempfile.TemporaryDirectory(prefix="corticle-browser-", ignore_cleanup_errors=True)
        to_browser, self.write_to = os.pipe()
        self.read_from, from_browser = os.pipe()
        graphics = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"] if webgl else ["--disable-gpu", "--disable-3d-apis"]
        root = ["--no-sandbox"] if os.geteuid() == 0 else []
        arguments = [command, "--headless=new", "--remote-debugging-pipe", f"--user-data-dir={self.profile.name}", "--no-first-run",
                     "--disable-extensions", "--disable-background-networking", "--disable-dev-shm-usage", "--hide-scrollbars",
                     "--host-resolver-rules=MAP * ~NOTFOUND", *graphics, *root, "about:blank"]

        def wire():
            high = [os.dup(to_browser), os.dup(from_browser)]  # 3 and 4 may be among the ends
            os.dup2(high[0], 3)
            os.dup2(high[1], 4)
        self.process = subprocess.Popen(arguments, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                        preexec_fn=wire, pass_fds=(3, 4))
        os.close(to_browser)
        os.close(from_browser)
        self.buffer = b""
        self.last = 0
        self.session = None
        self.forget()
        target = self.send("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.send("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.send(domain + ".enable")
        self.send("Network.emulateNetworkConditions", offline=True, latency=0, downloadThroughput=0, uploadThroughput=0)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.profile.cleanup()

    def processor_seconds(self):
        """Time that the processors have spent on the browser, in all of its processes; None where it is not known."""
        if not os.path.exists("/proc/self/stat"):
            return None
        parents, spent = {}, {}
        for number in filter(str.isdigit, os.listdir("/proc")):
            try:
                with open(f"/proc/{number}/stat", encoding="utf-8", errors="replace") as stream:
                    fields = stream.read().rpartition(")")[2].split()
            except OSError:
                continue  # it has ended
            parents[int(number)], spent[int(number)] = int(fields[1]), int(fields[11]) + int(fields[12])
        family = {self.process.pid}
        while more := {child for child, parent in parents.items() if parent in family} - family:
            family |= more
        return sum(spent[number] for number in family if number in spent) / os.sysconf("SC_CLK_TCK")

    def forget(self):
        self.problems, self.requests, self.loaded = [], [], False

    def message(self, seconds):
        """The next message of the browser."""
        deadline = time.monotonic() + seconds
        while b"\0" not in self.buffer:
            ready, _, _ = select.select([self.read_from], [], [], max(deadline - time.monotonic(), 0))
            if not ready:
                raise TimeoutError("the browser does not answer")
            piece = os.read(self.read_from, 1 << 20)
            if not piece:
                raise RuntimeError("the browser has ended")
            self.buffer += piece
        text, _, self.buffer = self.buffer.partition(b"\0")
        return json.loads(text)

    def note(self, event):
        """Keeps what tests ask for."""
        name, values = event.get("method"), event.get("params", {})
        if name == "Runtime.exceptionThrown":
            details = values["exceptionDetails"]
            self.problems.append(details.get("exception", {}).get("description", details["text"]))
        elif name == "Runtime.consoleAPICalled" and values["type"] in ("error", "warning", "assert"):
            self.problems.append(" ".join(str(part.get("value", part.get("description", ""))) for part in values["args"]))
        elif name == "Log.entryAdded" and values["entry"]["level"] in ("error", "warning"):
            self.problems.append(values["entry"]["text"])
        elif name == "Network.requestWillBeSent":
            self.requests.append(values["request"]["url"][:200])
        elif name == "Page.loadEventFired":
            self.loaded = True

    def send(self, method, seconds=60, **values):
        self.last += 1
        request = {"id": self.last, "method": method, "params": values}
        if self.session:
            request["sessionId"] = self.session
        os.write(self.write_to, json.dumps(request).encode() + b"\0")
        while True:
            answer = self.message(seconds)
            if answer.get("id") == self.last:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self.note(answer)

    def evaluate(self, expression, seconds=60):
        """The value of a JavaScript expression; promises are awaited."""
        answer = self.send("Runtime.evaluate", seconds, expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"].get("exception", {}).get("description", "exception in the page"))
        return answer["result"].get("value")

    def wait_for(self, condition, seconds=60):
        """True once the condition holds in the page."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            try:
                if self.evaluate(condition):
                    return True
            except RuntimeError:
                pass  # the page is being exchanged for another
            time.sleep(0.02)
        return False

    def resize(self, width, height, scale=1, mobile=False):
        self.send("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=mobile)

    def open(self, path, seconds=60):
        """Opens a file and waits until the page shows its first picture; False when it does not in time."""
        self.forget()
        self.send("Page.navigate", url=path.resolve().as_uri())
        return self.wait_for("document.documentElement?.dataset.ready === 'true'", seconds)

    def key(self, name):
        text = {" ": " "}.get(name, "")
        self.send("Input.dispatchKeyEvent", type="keyDown", key=name, text=text)
        self.send("Input.dispatchKeyEvent", type="keyUp", key=name)

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def screenshot(self, clip=None, whole=False, scale=1):
        """A PNG of the window, of the whole page, or of a box (x, y, width, height)."""
        options = {"captureBeyondViewport": whole}
        if whole:
            size = self.send("Page.getLayoutMetrics")["cssContentSize"]
            clip = (0, 0, size["width"], size["height"])
        if clip:
            options["clip"] = dict(zip(("x", "y", "width", "height"), clip), scale=scale)
        return base64.b64decode(self.send("Page.captureScreenshot", format="png", **options)["data"])


def pixels(png):
    """(width, height, rows of bytes, bytes of a pixel) of a PNG with 8 bits a channel."""
    at, data, width, height, channels = 8, b"", 0, 0, 0
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, _, color = struct.unpack(">IIBB", body[:10])
            channels = {2: 3, 6: 4}[color]
        elif kind == b"IDAT":
            data += body
        at += 12 + length
    raw, stride, rows, before = zlib.decompress(data), width * channels, [], bytearray(width * channels)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left = line[i - channels] if i >= channels else 0
            corner = before[i - channels] if i >= channels else 0
            if kind == 1:
                line[i] = line[i] + left & 255
            elif kind == 2:
                line[i] = line[i] + before[i] & 255
            elif kind == 3:
                line[i] = line[i] + (left + before[i]) // 2 & 255
            elif kind == 4:
                guess = left + before[i] - corner
                distances = abs(guess - left), abs(guess - before[i]), abs(guess - corner)
                line[i] = line[i] + (left, before[i], corner)[distances.index(min(distances))] & 255
        rows.append(line)
        before = line
    return width, height, rows, channels


def look(png):
    """(share of pixels that are not the background, share that are coloured, number of different hues)."""
    width, height, rows, channels = pixels(png)
    shown = colored = 0
    hues = set()
    for row in rows:
        for x in range(0, len(row), channels):
            r, g, b = row[x:x + 3]
            if min(r, g, b) < 245:
                shown += 1
                if max(r, g, b) - min(r, g, b) > 40:
                    colored += 1
                    hues.add((r // 64, g // 64, b // 64))
    return shown / (width * height), colored / (width * height), len(hues)

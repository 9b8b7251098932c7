"""The page of `reproduce` in a real browser, headless: pictures load, the seam moves, nothing complains, nothing is
fetched. Skipped where there is no Chromium."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from program import ProgramTest, environment

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
SKIPPED = 77


class Browser:
    """A page of headless Chromium, spoken to through a pipe (Chrome DevTools Protocol)."""

    def __init__(self, profile):
        to_browser, self.write_end = os.pipe()
        self.read_end, from_browser = os.pipe()

        def place_pipes():  # the browser reads from 3 and writes to 4
            low = [os.dup(to_browser), os.dup(from_browser)]
            os.dup2(low[0], 3)
            os.dup2(low[1], 4)

        self.process = subprocess.Popen(
            [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe",
             f"--user-data-dir={profile}", "--window-size=1200,900", "--allow-file-access-from-files", "about:blank"],
            preexec_fn=place_pipes, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.last, self.rest, self.events, self.session = 0, b"", [], None
        target = self.send("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.send("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.send(f"{domain}.enable")

    def message(self):
        while b"\0" not in self.rest:
            part = os.read(self.read_end, 1 << 20)
            if not part:
                raise RuntimeError("the browser has ended")
            self.rest += part
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def send(self, method, **parameters):
        self.last += 1
        request = {"id": self.last, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        data = json.dumps(request).encode() + b"\0"
        while data:
            data = data[os.write(self.write_end, data):]
        while True:
            message = self.message()
            if message.get("id") == self.last:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']}")
                return message["result"]
            self.events.append(message)

    def open(self, path):
        self.send("Page.navigate", url=path.as_uri())
        while not any(event.get("method") == "Page.loadEventFired" for event in self.events):
            self.events.append(self.message())

    def value(self, script):
        return self.send("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)["result"].get(
            "value")

    def press(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, clickCount=1)

    def complaints(self):
        return [event for event in self.events if event.get("method") == "Runtime.exceptionThrown"
                or (event.get("method") == "Log.entryAdded" and event["params"]["entry"]["level"] == "error")]

    def requests(self):
        return [event["params"]["request"]["url"].split(":")[0] for event in self.events
                if event.get("method") == "Network.requestWillBeSent"]

    def close(self):
        self.process.terminate()
        self.process.wait()
        os.close(self.write_end)
        os.close(self.read_end)


class Page(ProgramTest):
    def setUp(self):
        super().setUp()
        profile = tempfile.mkdtemp(prefix="timeshade-browser-")
        self.addCleanup(shutil.rmtree, profile, ignore_errors=True)
        self.browser = Browser(profile)
        self.addCleanup(self.browser.close)

    def made_page(self):
        """The page of a small list with a pair, a chart and a refuted claim."""
        papers = self.folder / "data" / "assets" / "papers"
        papers.mkdir(parents=True)
        (self.folder / "data" / "shaders").symlink_to(ROOT / "shaders")
        for name in ("page.css", "page.js"):
            (papers / name).symlink_to(ROOT / "assets" / "papers" / name)
        shot = "shot rising --size 160x120 --map 64 --spp 2 -o picture.png"
        sweep = "measure rising --spps 1,2 --size 32x24 --maps 32 --rounds 2 --reference 1 --reference-rays 0 -o ."
        figure = {"figure": "1", "status": "reproduced", "caption": "c",
                  "steps": {"a": shot + " --technique exact", "b": shot, "sweep": sweep + " --techniques exact"},
                  "pairs": [{"left": {"file": "a/picture.png", "caption": "l"},
                             "right": {"file": "b/picture.png", "caption": "r"}}],
                  "pictures": [{"file": "a/picture.png", "caption": "p"}],
                  "charts": [{"caption": "chart", "file": "sweep/accuracy.csv", "x": "spp", "y": "technique_bytes",
                              "by": "technique", "where": {"state": "cold"}}]}
        paper = {"name": "tiny", "authors": "A", "year": 2001, "title": "T", "figures": [figure]}
        (papers / "tiny.json").write_text(json.dumps(paper))
        self.succeed("reproduce", "tiny", "-o", "out", env=environment(TIMESHADE_DATA=self.folder / "data"))
        return self.folder / "out" / "index.html"

    def test_the_page_works(self):
        page = pathlib.Path(os.environ["TIMESHADE_PAGE"]) if "TIMESHADE_PAGE" in os.environ else self.made_page()
        self.assertLess(page.stat().st_size, 15 << 20)
        self.browser.open(page)
        images = self.browser.value("[...document.images].map(image => image.complete && image.naturalWidth)")
        self.assertGreaterEqual(len(images), 4)
        self.assertEqual([width for width in images if not width], [], "every picture has loaded")
        self.browser.value("document.querySelector('.pair').scrollIntoView()")
        seam = "getComputedStyle(document.querySelector('.wipe')).getPropertyValue('--seam')"
        self.assertEqual(self.browser.value(seam), "50%")
        x, y, width, height = self.browser.value(
            "(() => {const box = document.querySelector('.pair input').getBoundingClientRect();"
            "return [box.x, box.y, box.width, box.height];})()")
        self.browser.press(x + 0.9 * width, y + height / 2)
        self.assertGreater(float(self.browser.value(seam).rstrip("%")), 80)
        shown = "getComputedStyle(document.querySelector('.wipe .left')).clipPath"
        self.assertIn("inset", self.browser.value(shown))
        self.browser.value("document.querySelector('.pair button').click()")
        self.assertIn("scale(2)", self.browser.value("document.querySelector('.wipe img').style.transform"))
        self.browser.value("document.querySelector('.pictures img').click()")
        self.assertFalse(self.browser.value("document.getElementById('zoom').hidden"))
        self.assertEqual(self.browser.complaints(), [])
        self.assertEqual(set(self.browser.requests()) - {"file", "data", "about"}, set(), "nothing is fetched")


if __name__ == "__main__":
    if not CHROMIUM:
        print("skipped: there is no Chromium")
        raise SystemExit(SKIPPED)
    unittest.main()

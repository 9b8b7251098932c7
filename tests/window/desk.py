"""A display without a window manager, and a hand and an eye on it: Xvfb, xdotool and ImageMagick."""

import ctypes
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from thorough import THOROUGH, in_thorough_tests  # noqa: E402

PROGRAM = os.environ.get("TIMESHADE", "")
TOOLS = ("Xvfb", "xdotool", "convert")
SCREEN = (1600, 1000)
# A small picture: a software renderer draws it in well under a second. The driver's complaints end in exit code 1.
QUICK = ("--size", "900x600", "--spp", "2", "--map", "256", "--set", "accumulation.renders=4", "--gl-debug")
PANEL_WIDTH = 340
STATES_HEIGHT = 40
TABS = ("technique", "scene", "compare", "measure")


def missing_tools():
    return [tool for tool in TOOLS if shutil.which(tool) is None]


def differing(first, second, threshold):
    """A number with one bit for each byte that differs from the other by more than the threshold. All bytes at once, in
    16 bits each of one large number: a loop over them would take longer than the window does to draw them."""
    lanes = int.from_bytes(b"\1\0" * len(first), "little")

    def spread(data):
        wide = bytearray(2 * len(data))
        wide[::2] = data
        return int.from_bytes(wide, "little")

    one, other = spread(first), spread(second)
    base, reach = 256 * lanes, (255 - threshold) * lanes
    return (((one + base - other) + reach) | ((other + base - one) + reach)) & (512 * lanes)


class Picture:
    """Pixels of the screen, three bytes each, rows from the top."""

    def __init__(self, width, height, data):
        self.width, self.height, self.data = width, height, data

    def crop(self, x0, y0, x1, y1):
        rows = [self.data[3 * (y * self.width + x0):3 * (y * self.width + x1)] for y in range(y0, y1)]
        return Picture(x1 - x0, y1 - y0, b"".join(rows))

    def blackened(self, rows):
        """The uppermost rows are black."""
        return Picture(self.width, self.height, bytes(3 * self.width * rows) + self.data[3 * self.width * rows:])

    def grey(self):
        return [(2 * r + 5 * g + b) // 8 for r, g, b in zip(self.data[0::3], self.data[1::3], self.data[2::3])]

    def share_different(self, other, threshold=8):
        """Share of the pixels that differ by more than the threshold in any channel."""
        assert (self.width, self.height) == (other.width, other.height)
        if self.data == other.data:
            return 0.0
        flags = [differing(self.data[c::3], other.data[c::3], threshold) for c in range(3)]
        return bin(flags[0] | flags[1] | flags[2]).count("1") / (self.width * self.height)


def shown(dump, widget):
    """The widget's value; empty in a frame that does not lay it out."""
    return dump["widgets"].get(widget, {}).get("value", "")


class ClientMessage(ctypes.Structure):
    """Xlib's XClientMessageEvent, padded to the size of its XEvent."""

    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p),
                ("window", ctypes.c_ulong), ("message", ctypes.c_ulong), ("format", ctypes.c_int), ("data",
                                                                                                    ctypes.c_long * 5),
                ("padding", ctypes.c_long * 24)]


class XImage(ctypes.Structure):
    """The first fields of Xlib's own."""

    _fields_ = [("width", ctypes.c_int), ("height", ctypes.c_int), ("xoffset", ctypes.c_int), ("format", ctypes.c_int),
                ("data", ctypes.c_void_p), ("byte_order", ctypes.c_int), ("bitmap_unit", ctypes.c_int),
                ("bitmap_bit_order", ctypes.c_int), ("bitmap_pad", ctypes.c_int), ("depth", ctypes.c_int),
                ("bytes_per_line", ctypes.c_int), ("bits_per_pixel", ctypes.c_int)]


class Display:
    """An X server with nothing on it."""

    def __init__(self):
        reading, writing = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{SCREEN[0]}x{SCREEN[1]}x24", "-nolisten", "tcp",
             "-noreset"],
            pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as answer:
            self.name = ":" + answer.readline().strip()
        self.x11 = ctypes.CDLL("libX11.so.6")
        self.x11.XOpenDisplay.restype = self.x11.XGetImage.restype = ctypes.c_void_p
        self.x11.XDefaultRootWindow.restype = ctypes.c_ulong
        self.x11.XDefaultRootWindow.argtypes = self.x11.XCloseDisplay.argtypes = [ctypes.c_void_p]
        self.x11.XGetImage.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_int, ctypes.c_uint,
                                       ctypes.c_uint, ctypes.c_ulong, ctypes.c_int]
        self.x11.XFree.argtypes = [ctypes.c_void_p]
        self.connection = self.x11.XOpenDisplay(self.name.encode())

    def seen(self, width, height):
        """The upper left part of the screen."""
        every_plane, by_pixel = ctypes.c_ulong(-1).value, 2
        image = self.x11.XGetImage(self.connection, self.x11.XDefaultRootWindow(self.connection), 0, 0, width, height,
                                   every_plane, by_pixel)
        head = XImage.from_address(image)
        assert (head.bits_per_pixel, head.bytes_per_line) == (32, 4 * width), "a screen of another kind"
        data = ctypes.string_at(head.data, 4 * width * height)
        self.x11.XFree(head.data)
        self.x11.XFree(image)
        rgb = bytearray(3 * width * height)
        for channel in range(3):  # blue comes first
            rgb[channel::3] = data[2 - channel::4]
        return Picture(width, height, bytes(rgb))

    def close(self):
        self.x11.XCloseDisplay(self.connection)
        self.process.terminate()
        self.process.wait(timeout=20)


class Window:
    """The program's window. It is found, read and waited for through the JSON file that it writes for this purpose;
    everything else goes through the display, as a person's hands and eyes do."""

    def __init__(self, display, *arguments, **environment):
        self.display = display
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="timeshade-window-"))
        self.dump_path = self.folder / "ui.json"
        self.errors = open(self.folder / "stderr", "w+b")
        self.environment = {**os.environ, "DISPLAY": display.name, "TIMESHADE_UI_SCALE": "1",
                            "TIMESHADE_UI_DUMP": str(self.dump_path),
                            "XDG_CONFIG_HOME": str(self.folder / "config")}
        self.environment.pop("WAYLAND_DISPLAY", None)
        self.environment.update(environment)
        self.process = subprocess.Popen([PROGRAM, "view", *arguments], cwd=self.folder, env=self.environment,
                                        stdout=subprocess.DEVNULL, stderr=self.errors)
        self.id = None
        self.wait(lambda dump: True, "a first frame")
        self.id = self.hand("search", "--onlyvisible", "--name", "Timeshade").split()[0]
        self.focus()

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.errors.close()
        shutil.rmtree(self.folder, ignore_errors=True)

    def hand(self, *arguments):
        return subprocess.run(["xdotool", *arguments], env=self.environment, check=True, capture_output=True, text=True,
                              timeout=120).stdout

    def standard_error(self):
        self.errors.seek(0)
        return self.errors.read().decode(errors="replace")

    # What the window says of itself.

    def dump(self):
        try:
            return json.loads(self.dump_path.read_text())
        except FileNotFoundError:
            return None

    def state(self):
        return self.dump()["state"]

    def widget(self, name):
        return self.dump()["widgets"].get(name)

    def wait(self, condition, what, seconds=120):
        """The first dump that fulfils the condition."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            dump = self.dump()
            if dump is not None and condition(dump):
                return dump
            if self.process.poll() is not None:
                raise AssertionError(f"waiting for {what}, the program ended with {self.process.returncode}: "
                                     f"{self.standard_error()}")
            time.sleep(0.03)
        raise AssertionError(f"waited {seconds} s for {what}; the window says {dump['state'] if dump else None}")

    def wait_state(self, **wanted):
        return self.wait(lambda dump: all(dump["state"].get(key) == value for key, value in wanted.items()),
                         f"{wanted}")

    def settle(self, **wanted):
        """The picture is whole, and the window knows that it has been asked for these."""
        return self.wait_state(settled=True, **wanted)

    # What a person does.

    def focus(self):
        self.hand("windowfocus", "--sync", self.id)

    def key(self, *names):
        """Presses keys, one after the other, and returns when the window has heeded them."""
        before = self.state()["keys"]
        for name in names:
            self.hand("key", name)
        self.wait(lambda dump: dump["state"]["keys"] >= before + len(names), f"the keys {names}")

    def type(self, text):
        self.hand("type", "--delay", "12", text)

    def frames(self, count):
        """Waits until the window has drawn so many more."""
        before = self.state()["frames"]
        self.wait(lambda dump: dump["state"]["frames"] >= before + count, f"{count} frames")

    def point(self, x, y):
        self.hand("mousemove", str(int(x)), str(int(y)))
        self.wait(lambda dump: dump["state"]["mouse"][:2] == [int(x), int(y)], f"the mouse at {int(x)}, {int(y)}")

    def button(self, number, down):
        self.hand("mousedown" if down else "mouseup", number)
        self.wait(lambda dump: dump["state"]["mouse"][2] == down, f"button {number} {'down' if down else 'up'}")

    def wheel(self, notches):
        """Up for positive ones."""
        for _ in range(abs(notches)):
            self.hand("click", "4" if notches > 0 else "5")
        self.frames(2)

    def open_tab(self, name):
        x0, y0, x1, y1 = self.widget(f"tab/{name}")["rect"]
        self.press_at((x0 + x1) / 2, (y0 + y1) / 2)
        self.wait(lambda dump: dump["widgets"].get(f"tab/{name}", {}).get("value"), f"the tab {name}")
        self.frames(2)

    def find_tab(self, name):
        """Opens the tab of the side panel that the widget is on, where that is not open."""
        for tab in TABS:
            if self.widget(name) is not None or self.widget(f"tab/{tab}") is None:
                return
            self.open_tab(tab)

    def value(self, name):
        """Of a widget, whatever tab it is on."""
        self.find_tab(name)
        return self.widget(name)["value"]

    def reveal(self, name):
        """Opens its tab and scrolls the side panel until the widget can be clicked. Returns its rectangle."""
        self.find_tab(name)
        for _ in range(60):
            widget = self.widget(name)
            assert widget is not None, f"no widget {name}; there are {sorted(self.dump()['widgets'])}"
            x0, y0, x1, y1 = widget["rect"]
            height = self.state()["window"][1]
            if widget["visible"] and y0 >= 0 and y1 <= height:
                return x0, y0, x1, y1
            self.point(12, height - 12)  # below the tabs, however low the window is
            self.wheel(-1 if y1 > height else 1)
        raise AssertionError(f"widget {name} can't be scrolled into view")

    def press_at(self, x, y, button="1"):
        self.point(x, y)
        self.button(button, True)
        self.button(button, False)

    def click(self, name):
        x0, y0, x1, y1 = self.reveal(name)
        self.press_at((x0 + x1) / 2, (y0 + y1) / 2)

    def choose(self, combo, entry):
        self.click(combo)
        name = f"{combo}/{entry}"
        self.wait(lambda dump: name in dump["widgets"], f"the list of {combo} with {entry}")
        self.frames(2)  # the list has its size and place
        self.click(name)

    def drag(self, x0, y0, x1, y1, button="1"):
        self.point(x0, y0)
        self.button(button, True)
        for i in range(1, 6):
            self.point(x0 + (x1 - x0) * i / 5, y0 + (y1 - y0) * i / 5)
        self.button(button, False)

    def drag_slider(self, name, share):
        """Drags from the middle of the slider to a share of its width. Returns the new value."""
        x0, y0, x1, y1 = self.reveal(name)
        y = (y0 + y1) / 2
        self.drag((x0 + x1) / 2, y, x0 + share * (x1 - x0), y)
        self.settle()
        return self.widget(name)["value"]

    def resize(self, width, height):
        self.hand("windowsize", self.id, str(width), str(height))
        self.wait_state(window=[width, height])

    # What a person sees.

    def look(self):
        """The whole window."""
        time.sleep(0.1)  # what the window has drawn last may still be on its way to the screen
        return self.display.seen(*self.state()["window"])

    def look_at_picture(self):
        """Only the picture, without panels and without the row of states at its upper edge."""
        return self.look_at_whole_picture().blackened(STATES_HEIGHT)

    def look_at_whole_picture(self):
        (width, height), (window_width, _) = self.state()["drawn"], self.state()["window"]
        return self.look().crop(window_width - width, 0, window_width, height)

    def ask_to_close(self):
        """What a window manager sends when the button in the title bar is pressed."""
        x11 = ctypes.CDLL("libX11.so.6")
        x11.XOpenDisplay.restype = ctypes.c_void_p
        x11.XInternAtom.restype = ctypes.c_ulong
        x11.XInternAtom.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int]
        x11.XSendEvent.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_long, ctypes.c_void_p]
        x11.XCloseDisplay.argtypes = [ctypes.c_void_p]
        display = x11.XOpenDisplay(self.environment["DISPLAY"].encode())
        event = ClientMessage(type=33, window=int(self.id), message=x11.XInternAtom(display, b"WM_PROTOCOLS", 0),
                              format=32)
        event.data[0] = x11.XInternAtom(display, b"WM_DELETE_WINDOW", 0)
        x11.XSendEvent(display, int(self.id), 0, 0, ctypes.byref(event))
        x11.XCloseDisplay(display)  # sends it

    def quit(self):
        self.hand("key", "ctrl+q")
        return self.process.wait(timeout=120)


class WindowTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.display = Display()
        cls.addClassCleanup(cls.display.close)

    def open(self, *arguments, **environment):
        window = Window(self.display, *arguments, **environment)
        self.addCleanup(window.close)
        return window

    def close(self, window):
        """As at the end of every test: it goes when told to, and has had nothing to complain of."""
        self.assertEqual(window.quit(), 0, window.standard_error())
        self.assertEqual(window.standard_error(), "")


def headless(command, folder, **environment):
    """Runs a command line that the window has copied, in a shell and without a display."""
    names = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    names.update(environment)
    script = f"timeshade() {{ {PROGRAM!r} \"$@\"; }}\n{command}"
    done = subprocess.run(["bash", "-c", script], cwd=folder, env=names, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, f"{command}\n{done.stderr}"


def pixels(path):
    """A picture file without what is written beside its pixels."""
    return subprocess.run(["convert", path, "-depth", "8", "ppm:-"], check=True, capture_output=True).stdout


def run_tests():
    """Exits with 77 where a display can't be had."""
    if missing_tools():
        print(f"skipped: {', '.join(missing_tools())} not found")
        sys.exit(77)
    unittest.main()

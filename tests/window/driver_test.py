"""The window and the driver: what goes wrong there is said, and nothing waits for the device while it plays."""

import json
import subprocess

from desk import PROGRAM, WindowTest, run_tests, shown

SMALL = ("--size", "640x480", "--spp", "1", "--map", "64")


class Driver(WindowTest):
    def test_an_error_of_the_driver_is_shown_and_survived(self):
        window = self.open("pillars", "--technique", "tsm", *SMALL, TIMESHADE_TEST_GL_ERROR="lookup")
        told = window.wait(lambda dump: shown(dump, "failure"), "the failure")
        self.assertIn("the driver reports GL_INVALID_ENUM", shown(told, "failure"))
        window.key("1", "space")
        window.wait(lambda dump: dump["state"]["technique"] == "static" and shown(dump, "failure"), "the next failure")
        window.frames(5)
        self.close(window)

    def test_nothing_waits_while_it_plays(self):
        listed = json.loads(subprocess.run([PROGRAM, "list", "--json"], check=True, capture_output=True).stdout)
        window = self.open("crossing", *SMALL)
        window.key("space")
        for number, technique in enumerate(listed["techniques"][:9], 1):
            window.key(str(number))
            window.wait(lambda dump, name=technique["name"]: dump["state"]["technique"] == name, technique["name"])
            first = window.state()["begun"]
            early = window.wait(lambda dump, n=first + 4: dump["state"]["begun"] >= n, "four pictures")["state"]
            late = window.wait(lambda dump, n=first + 14: dump["state"]["begun"] >= n, "ten more")["state"]
            # Fewer than one a picture: a change of the preview makes other lists, of whose length nothing is known.
            self.assertLessEqual(late["waits"] - early["waits"], 4, technique["name"])
        self.close(window)


if __name__ == "__main__":
    run_tests()

"""measure --times: what frames take, on the device and on the processor."""

import unittest

from program import ProgramTest


class Times(ProgramTest):
    def test_what_frames_take_on_device_and_processor(self):
        self.succeed("measure", "crossing", "--times", "--techniques", "static,exact", "--size", "64x48",
                     "--maps", "64", "--spps", "2", "--rounds", "2", "--sequence", "2", "-o", "F")
        table = [line.split(" | ") for line in (self.folder / "F/times.md").read_text().splitlines()
                 if line.startswith("| crossing")]
        self.assertEqual([(row[1], row[4]) for row in table],
                         [(name, state) for name in ("static", "exact") for state in ("cold", "filling", "steady")])
        lines = (self.folder / "F/times.csv").read_text().splitlines()
        self.assertEqual(lines[0], "scene,technique,spp,map,state,clock,step,median_ms,low_ms,high_ms")
        for step in ("device,sample", "device,build", "device,lookup", "device,shade", "device,total",
                     "processor,plan", "processor,total", "wall,whole"):
            self.assertTrue(any(line.startswith(f"crossing,exact,2,64,steady,{step},") for line in lines), step)
        for line in lines[1:]:
            median, low, high = map(float, line.split(",")[-3:])
            self.assertTrue(0.0 <= low <= median <= high, line)

    def test_the_ray_tracer_has_no_frames(self):
        self.refuse(2, ("embree",), "measure", "crossing", "--times", "--techniques", "embree", "-o", "F")


if __name__ == "__main__":
    unittest.main()

"""What the compiler and the linker add to a release build against holes in it, read from the binary."""

import re
import subprocess
import unittest

from program import PROGRAM


def read(*options):
    return subprocess.run(["readelf", "--wide", *options, PROGRAM], check=True, capture_output=True, text=True).stdout


class Hardening(unittest.TestCase):
    def test_addresses_cannot_be_foreseen(self):
        self.assertRegex(read("--file-header"), r"Type:\s+DYN")
        self.assertRegex(read("--dynamic"), r"FLAGS_1.*\bPIE\b")

    def test_tables_of_calls_are_read_only(self):
        self.assertIn("GNU_RELRO", read("--program-headers"))
        self.assertRegex(read("--dynamic"), r"\bBIND_NOW\b|\bNOW\b")

    def test_no_segment_is_both_written_and_run(self):
        flags = re.findall(r"^\s+(\w+)(?:\s+0x\w+){5}\s+([RWE ]{3})", read("--program-headers"), re.MULTILINE)
        self.assertIn("GNU_STACK", [kind for kind, _ in flags])
        self.assertEqual([kind for kind, flag in flags if "W" in flag and "E" in flag], [])

    def test_stack_and_buffers_are_checked(self):
        """In functions of our own: libraries that are linked in come with checks of theirs."""
        names = subprocess.run(["nm", PROGRAM], check=True, capture_output=True, text=True).stdout
        (reader,) = re.findall(r"\b(_ZN9timeshade13readFileBytes\w+)$", names, re.MULTILINE)  # it has an array
        code = subprocess.run(["objdump", f"--disassemble={reader}", PROGRAM], check=True, capture_output=True,
                              text=True).stdout
        self.assertTrue("__stack_chk_fail" in code, reader)
        self.assertTrue("__longjmp_chk" in names, "what FORTIFY makes of the decoders' longjmp")


if __name__ == "__main__":
    unittest.main()

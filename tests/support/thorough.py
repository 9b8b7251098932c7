"""What is tested over and over is tested in part as a rule, and whole where TIMESHADE_TESTS=thorough, as .ci/run has it
(tests/support/thorough.h says the same to C++)."""

import os
import unittest

THOROUGH = os.environ.get("TIMESHADE_TESTS") == "thorough"
in_thorough_tests = unittest.skipUnless(THOROUGH, "drawn where TIMESHADE_TESTS=thorough")


def drawn(values, other=0):
    """As a rule every third, with `other` those beside it."""
    return values if THOROUGH else values[other % 3::3]

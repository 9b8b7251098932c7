"""What is tested over and over is tested in part as a rule, more of it where TIMESHADE_TESTS=thorough, as .ci/run has
it, and all where TIMESHADE_TESTS=all (tests/support/thorough.h says the same to C++)."""

import os
import unittest

ALL = os.environ.get("TIMESHADE_TESTS") == "all"
THOROUGH = ALL or os.environ.get("TIMESHADE_TESTS") == "thorough"
in_thorough_tests = unittest.skipUnless(THOROUGH, "drawn where TIMESHADE_TESTS=thorough")


def drawn(values, other=0):
    """As a rule every third, with `other` those beside it."""
    return values if THOROUGH else values[other % 3::3]

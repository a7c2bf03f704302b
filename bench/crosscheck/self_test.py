"""Can the cross-check be trusted? build/crosscheck-venv/bin/python bench/crosscheck/self_test.py"""

import sys
import unittest
from pathlib import Path

from variant import use_fastest_variant

if __name__ == "__main__":
    use_fastest_variant()
    tests = unittest.defaultTestLoader.discover(str(Path(__file__).parent), "*_test.py")
    # `self_test.py` matches too, and has no tests.
    sys.exit(not unittest.TextTestRunner().run(tests).wasSuccessful())

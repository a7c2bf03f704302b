"""Can the cross-check be trusted? build/crosscheck-venv/bin/python bench/crosscheck/self_test.py [llvm_ad_rgb|scalar_rgb]"""

import sys
import unittest
from pathlib import Path

from variant import use_variant

if __name__ == "__main__":
    use_variant(sys.argv[1] if sys.argv[1:] else None)
    tests = unittest.defaultTestLoader.discover(str(Path(__file__).parent), "*_test.py")
    # `self_test.py` matches too, and has no tests.
    sys.exit(not unittest.TextTestRunner().run(tests).wasSuccessful())

"""methods.json is what the program says: methods_test.py SHLMBENCH. With --write after it, writes the file anew."""

import json
import subprocess
import sys
import unittest

from known_methods import FILE, KNOWN

PROGRAM = sys.argv.pop(1)


def said(names):
    return json.loads(subprocess.run([PROGRAM, "methods", "--json", *names], capture_output=True, check=True, text=True).stdout)


class KnownMethods(unittest.TestCase):
    def test_are_as_the_program_says(self):
        self.assertEqual(list(KNOWN.values()), said(KNOWN)["methods"])


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        FILE.write_text(json.dumps({"methods": said(KNOWN)["methods"]}, indent=1) + "\n", encoding="utf-8")
    else:
        unittest.main()

"""What is being done, on stderr."""

import sys


def say(text):
    print(f"bench/track: {text}", file=sys.stderr, flush=True)

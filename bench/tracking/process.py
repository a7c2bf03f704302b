"""A program run for what it prints."""

import subprocess


class MeasurementFailed(Exception):
    """Its text is what the program said at last: why it ended, or which of its answers are wrong."""


def output_of(command, **how):
    done = subprocess.run(command, capture_output=True, text=True, **how)
    if done.returncode != 0:
        raise MeasurementFailed((done.stderr.strip().splitlines() or [f"{command[0]}: exit code {done.returncode}"])[-1])
    return done.stdout

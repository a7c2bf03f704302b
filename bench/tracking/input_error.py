"""What is wrong with what was asked for."""


class InputError(Exception):
    """Its text is one line for the user; the command ends with exit code 2."""

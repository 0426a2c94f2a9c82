"""What goes wrong in a way that the user can mend."""


class ExperimentError(Exception):
    """Its text is one clear line."""

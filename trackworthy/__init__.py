"""The program's face: one thin file a command."""

__version__ = "0.1.0"

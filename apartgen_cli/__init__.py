"""The command line: one file per command, each thin over its stage."""

__version__ = "0.1.0"

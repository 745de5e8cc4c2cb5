"""Which version this is: what `apartgen.__version__`, artifacts and the package say."""

__version__ = "0.2.0"

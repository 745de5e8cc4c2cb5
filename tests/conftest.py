"""Makes the modules of this folder importable from the test folders below it."""

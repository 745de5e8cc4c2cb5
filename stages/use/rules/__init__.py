"""Faults of use, one activity a file: `faults(room) -> Iterator[Fault]`, each by a name that `faults.toml` weighs."""

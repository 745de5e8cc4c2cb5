"""The six stages, each `run(previous, config, rng) -> next`, and the modules that two of them need."""

"""From a sentence to a furnished, simulation-ready apartment."""

"""Data sets of homes: made on all cores, resumed after any end, verified, cited and rebuilt home by home.

A data set is a folder: `dataset.json` says what was asked for, `manifest.jsonl` has a row for every home in order,
`homes/` holds the artifacts, one line each in shards of JSON Lines whose every line is a gzip member of its own.
"""

"""`python -m apartgen_cli`."""

from apartgen_cli.main import main

main()

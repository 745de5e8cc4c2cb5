"""Robots in the exported apartment, in physics: do they get everywhere, and can they open what opens? (4.7, Table 6)

`world` builds the simulation from the exported MJCF, `navigate` and `interact` run its episodes, `replay` shows them,
`episodes` writes them down for other simulators.
"""

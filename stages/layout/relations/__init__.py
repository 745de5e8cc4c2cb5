"""A layout model in relations: objects come in functional order, each described from a wall or an earlier object.

`contents` draws what a room holds, `network` what stands where in whose frame, `sampler` picks from its posterior what
breaks nothing; `train` fits all of it.
"""

"""What is compiled is said once a process."""

import logging

from apartgen.stages import compiling


def test_compiling_is_said_once(caplog):
    said = compiling._Said()
    with caplog.at_level(logging.INFO):
        for _ in range(3):
            said.on_start(None)
    assert len(caplog.records) == 1 and "compiling" in caplog.text

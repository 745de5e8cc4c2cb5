"""Many cases: `PYTHONPATH=tests python -m fuzz [CASES] [SEED] [TARGET]`; ends with 1 where a case fails.

A case fails with anything but an answer or an ApartgenError, after ten seconds of a processor, or above 4 GB.
"""

import logging
import resource
import signal
import sys
import tempfile
import time
import traceback
from pathlib import Path

from fuzz.targets import SHARE, SLOW, passes

LONGEST, MOST = 10, 4 * 2**30


def main(cases: int = 20_000, seed: int = 1, name: str = "") -> int:
    """Exit status 1 for any fault."""
    logging.getLogger("apartgen").setLevel(logging.CRITICAL + 1)
    resource.setrlimit(resource.RLIMIT_AS, (2 * MOST, 2 * MOST))  # addresses; what is in use is measured below
    signal.signal(signal.SIGPROF, _late)
    shares = {target: share for target, share in (SHARE | SLOW).items() if name in ("", target.__name__)}
    failed = 0
    for target, share in shares.items():
        count, began, slowest = max(1, round(cases * share / sum(shares.values()))), time.process_time(), 0.0
        faults = 0
        for i in range(seed * 10_000_000, seed * 10_000_000 + count):
            start = time.process_time()
            with tempfile.TemporaryDirectory() as folder:
                signal.setitimer(signal.ITIMER_PROF, LONGEST)
                try:
                    passes(target, i, Path(folder))
                except BaseException as error:
                    if isinstance(error, KeyboardInterrupt):
                        raise
                    faults += 1
                    where = traceback.extract_tb(error.__traceback__)[-1]
                    print(f"{target.__name__} {i}: {type(error).__name__}: {str(error)[:200]} at {where.filename}:"
                          f"{where.lineno}", flush=True)
                finally:
                    signal.setitimer(signal.ITIMER_PROF, 0)
            slowest = max(slowest, time.process_time() - start)
        print(f"{target.__name__}: {count} cases, {faults} faults, slowest {slowest:.1f} s, "
              f"{time.process_time() - began:.0f} s in all", flush=True)
        failed += faults
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    print(f"most memory {most / 2**20:.0f} MB")
    return 1 if failed or most > MOST else 0


def _late(*_: object) -> None:
    raise TimeoutError(f"busy for {LONGEST} s")


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:3]), *sys.argv[3:]))

# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a run is: tqdm where it is installed, else a line on stderr."""

import sys
import time
from typing import Any, Optional


class _Line:
    """A line on stderr, drawn anew twice a second."""

    def __init__(self, total: float) -> None:
        self._total = total
        self._drawn = 0.0

    def show(self, done: float, text: str) -> None:
        if time.monotonic() - self._drawn >= 0.5:
            self._drawn = time.monotonic()
            print(f"\r{100.0 * done / self._total:5.1f} %  {text}", end="", file=sys.stderr, flush=True)

    def close(self) -> None:
        print(file=sys.stderr)


class _Bar:
    def __init__(self, tqdm: Any, total: float) -> None:
        self._bar = tqdm(total=total, bar_format="{l_bar}{bar}| {elapsed}<{remaining}{postfix}")

    def show(self, done: float, text: str) -> None:
        self._bar.set_postfix_str(text, refresh=False)
        self._bar.update(done - self._bar.n)

    def close(self) -> None:
        self._bar.close()


class Progress:
    """Shows growth time on its way from `start` to `end`, if it is wanted."""

    def __init__(self, wanted: bool, start: float, end: float) -> None:
        self._start = start
        self._shown: Optional[Any] = _shown(end - start) if wanted and end > start else None

    @property
    def tell(self) -> Any:
        """To be called with t and the number of steps; None where nothing is shown."""
        return self._tell if self._shown else None

    def _tell(self, t: float, steps: int) -> None:
        if self._shown:
            self._shown.show(t - self._start, f"t {t:.4f}, step {steps}")

    def __enter__(self) -> "Progress":
        return self

    def __exit__(self, *_: Any) -> None:
        if self._shown:
            self._shown.close()


def _shown(total: float) -> Any:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return _Line(total)
    return _Bar(tqdm, total)

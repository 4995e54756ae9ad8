# SPDX-License-Identifier: GPL-3.0-or-later
"""What draws pictures works in a process of its own: the library starts an X server there and sets DISPLAY, which is
nothing to do to the process of the user. Run as `python -m corticle._child`, a request on stdin, the answer on stdout."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict

from corticle.errors import InputError, RunError

_ERRORS = {"InputError": InputError, "RunError": RunError}


def call(function: str, *arguments: Any) -> Any:
    """A function of the compiled module, called in a child process.

    Raises:
        InputError, RunError: as the function does there; RunError also where the child ends without an answer.
    """
    places = [str(Path(__file__).parents[1]), *filter(None, [os.environ.get("PYTHONPATH")])]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(places)}
    done = subprocess.run([sys.executable, "-m", "corticle._child"], input=json.dumps([function, *arguments]),
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False, env=environment)
    try:
        answer: Dict[str, Any] = json.loads(done.stdout)
    except ValueError:
        last = (done.stderr.strip() or "no message").splitlines()[-1]
        raise RunError(f"{function}: the process that draws ended with status {done.returncode}: {last}") from None
    if "error" in answer:
        raise _ERRORS.get(answer["error"], RunError)(answer["message"])
    return answer["result"]


def _main() -> None:
    function, *arguments = json.load(sys.stdin)
    from corticle import _corticle

    try:
        answer: Dict[str, Any] = {"result": getattr(_corticle, function)(*arguments)}
    except (InputError, RunError) as error:
        answer = {"error": type(error).__name__, "message": str(error)}
    json.dump(answer, sys.stdout)


if __name__ == "__main__":
    _main()

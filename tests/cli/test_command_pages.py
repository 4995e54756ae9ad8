# SPDX-License-Identifier: GPL-3.0-or-later
"""The manual page and the completions that the command makes of its own help."""

import re
import shutil
import subprocess

import _command


def page(bench, form):
    return bench.write(f"corticle.{form}", bench.accepted("schema", "--of-command", form))


def verbs_and_options(bench):
    """What --help shows: {verb: its options}."""
    verbs = re.findall(r"^  (\w+)  ", bench.accepted("--help").split("Subcommands:")[1], re.MULTILINE)
    return {verb: re.findall(r"^  (?:-\w,)?(--[\w-]+)", bench.accepted(verb, "--help"), re.MULTILINE) for verb in verbs}


def every_page_holds_what_help_shows(bench):
    shown = verbs_and_options(bench)
    bench.check(len(shown) > 10 and "--out" in shown["run"], f"--help is read wrongly: {shown}")
    words = {option for options in shown.values() for option in options}
    for form in ("man", "bash", "zsh", "fish"):
        text = (bench.folder / page(bench, form)).read_text().replace("\\-", "-")
        missing = [word for word in [*shown, *words] if word.removeprefix("--" if form == "fish" else "") not in text]
        bench.check(not missing, f"{form} lacks {missing}")
    bench.refused(["schema", "--of-command", "tcsh"], ["tcsh", "zsh"])


def checked(bench, tool, *command):
    """Runs a checker where it is installed; what it says is a fault."""
    if shutil.which(tool) is None:
        print(f"no {tool}: not checked by it")
        return
    done = subprocess.run([tool, *command], cwd=bench.folder, capture_output=True, text=True, timeout=60, check=False)
    bench.check(done.returncode == 0 and not done.stderr, f"{tool} {command}: {done.returncode} {done.stdout}{done.stderr}")


def tools_accept_them(bench):
    manual = page(bench, "man")
    checked(bench, "mandoc", "-T", "lint", "-W", "error", manual)
    checked(bench, "man", "--warnings=all", "-l", "-Tutf8", "-P", "cat", manual)
    for shell in ("bash", "zsh", "fish"):
        checked(bench, shell, "-n", page(bench, shell))


def bash_offers(bench):
    script = page(bench, "bash")
    ask = """
        source "$0"
        compopt() { :; }
        COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
        _corticle corticle "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
        printf '%s\\n' "${COMPREPLY[@]}"
    """

    def offered(*words):
        return subprocess.run(["bash", "-c", ask, script, "corticle", *words], cwd=bench.folder, capture_output=True, text=True,
                              timeout=60, check=True).stdout.split()

    for words, expected in ((["ren"], ["render"]), (["run", "--o"], ["--out", "--overwrite"]),
                            (["export", "r", "--format", "g"], ["gifti"]), (["run", "--set", "geometry.par"], ["geometry.particles="]),
                            (["run", "ca"], [])):  # nothing of its own: bash offers files
        bench.check(offered(*words) == expected, f"bash offers {offered(*words)} for {words}, expected {expected}")


_command.main(__doc__, every_page_holds_what_help_shows, tools_accept_them, bash_offers)

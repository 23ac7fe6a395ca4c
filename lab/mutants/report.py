"""docs/mutants.md: every mutant, and the test that noticed it or why none can."""

import tomllib
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from turnbuckle.lab.mutants.draw import sources
from turnbuckle.lab.mutants.mutation import Mutation
from turnbuckle.lab.mutants.objects import ROOT
from turnbuckle.lab.mutants.trial import Verdict

REPORT = ROOT / "docs" / "mutants.md"
EXPLAINED = Path(__file__).parent / "explained.toml"
MOST = 0.02
"""Share of the mutants that may survive."""

Results = Sequence[tuple[Mutation, Verdict]]

HEAD = """# Mutants of the runtime

`make mutants` makes one small change in `runtime/core` or `runtime/canopen`, compiles it, and runs
the tests that concern the file until one fails: {tried} mutants, drawn at random from all of which
gcc makes other object code; {killed} are noticed, {survive} survive. `lab/mutants` says which
changes are made and which tests are run.

{files}
"""


def report(results: Results) -> str:
    """The whole page."""
    survivors = [mutant for mutant, verdict in results if not verdict.killer]
    counts = {"tried": len(results), "survive": len(survivors)}
    counts["killed"] = counts["tried"] - counts["survive"]
    page = [HEAD.format(**counts, files=_files(results))]
    if survivors:
        page.append(_survivors(survivors))
    return "\n".join([*page, _noticed(results)])


def judge(results: Results) -> list[str]:
    """What is wrong: too many survive, or one is not explained."""
    survivors = [mutant for mutant, verdict in results if not verdict.killer]
    found = [
        f"{mutant.file}:{mutant.line} {mutant.words} survives:"
        f" write the test that notices it, or say in {EXPLAINED.name} why none can"
        for mutant in survivors
        if explanation(mutant) is None
    ]
    if len(survivors) > MOST * len(results):
        found.append(f"{len(survivors)} of {len(results)} mutants survive, {MOST:.0%} may")
    return found


def explanation(mutant: Mutation) -> str | None:
    """Why no test can notice a mutant, if that is known."""
    where = mutant.place_in(sources()[mutant.file])
    wanted = {"file": mutant.file, "where": where, "change": mutant.words}
    for entry in tomllib.loads(EXPLAINED.read_text())["survivor"]:
        if all(entry[key] == value for key, value in wanted.items()):
            return str(entry["why"])
    return None


def _files(results: Results) -> str:
    tried = Counter(mutant.file for mutant, _ in results)
    alive = Counter(mutant.file for mutant, verdict in results if not verdict.killer)
    rows = [f"| `runtime/{file}` | {tried[file]} | {alive[file]} |" for file in sorted(tried)]
    return "\n".join(["| file | mutants | survive |", "|---|---|---|", *rows, ""])


def _survivors(survivors: Sequence[Mutation]) -> str:
    rows = [
        f"| `{mutant.file}:{mutant.line}` | {_cell(mutant)} | {explanation(mutant) or '?'} |"
        for mutant in survivors
    ]
    return "\n".join(["## Survivors\n", "| place | change | why |", "|---|---|---|", *rows, ""])


def _noticed(results: Results) -> str:
    rows = [
        f"| `{mutant.file}:{mutant.line}` | {_cell(mutant)} | {_test(verdict)} |"
        for mutant, verdict in results
        if verdict.killer
    ]
    return "\n".join(["## Noticed\n", "| place | change | by |", "|---|---|---|", *rows, ""])


def _cell(mutant: Mutation) -> str:
    return mutant.words.replace("|", "\\|")


def _test(verdict: Verdict) -> str:
    """The test that noticed, without its parameters, and how where it did not just fail."""
    path, _, test = verdict.killer.partition("::")
    how = "" if verdict.how == "fails" else f" ({verdict.how})"
    return f"`{Path(path).name}` {test.split('[')[0]}{how}".replace("|", "\\|")

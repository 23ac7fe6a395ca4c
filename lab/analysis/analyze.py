"""From a machine to a folder that says whether it is any good."""

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from turnbuckle.codegen.folder import refuse_foreign, write_folder
from turnbuckle.lab.analysis.figures import Findings
from turnbuckle.lab.analysis.plots import AnyPanel, Mark, Outline, Quantity, draw
from turnbuckle.lab.analysis.quantities import lag_quantity, quantities
from turnbuckle.lab.analysis.report import MANIFEST, REPORT, as_json, as_markdown
from turnbuckle.lab.analysis.slices import lag_panels, panels
from turnbuckle.model.machine import Machine
from turnbuckle.model.workspace.extent import workspace_extent
from turnbuckle.model.workspace.inscribed import Inscribed
from turnbuckle.model.workspace.rows import Array
from turnbuckle.model.workspace.summary import fine_grid, summarise_target
from turnbuckle.model.workspace.words import pose_in_words

Progress = Callable[[str, float], None]

CIRCLE, SCREEN, CAPABLE = "#CC79A7", "#000000", "#56B4E9"
POINTS = 60  # of an outline


def analyze(
    machine: Machine,
    folder: Path,
    lag: float,
    progress: Progress = lambda stage, share: None,
    force: bool = False,
) -> Findings:
    """Look at a machine and write maps, numbers and report into a folder.

    lag [m]: how far bases are behind the hand in the maps of late bases. Raises FolderError when
    the folder holds something else, or without force another machine's, or cannot be written.
    """
    refuse_foreign(folder, MANIFEST, [machine.name], force)  # before the long work
    findings = find(machine, lag, progress)
    pictures = draw_maps(findings, lag, progress)
    names = [REPORT, *(f"{quantity.name}.png" for quantity, _ in pictures)]
    files: dict[str, str | bytes] = {
        MANIFEST: as_json(findings, names),
        REPORT: as_markdown(findings, [quantity for quantity, _ in pictures]),
    }
    files |= {f"{quantity.name}.png": png for quantity, png in pictures}
    write_folder(files, folder, MANIFEST, force)
    return findings


def find(machine: Machine, lag: float, progress: Progress = lambda stage, share: None) -> Findings:
    """The numbers of a machine."""
    stage = f"looking at the target of {machine.name}"
    target = summarise_target(
        machine, fine_grid(machine), lag, lambda done, total: progress(stage, done / total)
    )
    progress(f"looking for the largest screen of {machine.name}", 0.0)
    return Findings(machine, target, workspace_extent(machine))


def draw_maps(findings: Findings, lag: float, progress: Progress) -> list[tuple[Quantity, bytes]]:
    """Every map with its PNG, the most useful first."""
    machine, coverage = findings.machine, findings.target.coverage
    words = f"worst pose, {pose_in_words(machine, coverage.worst)}"
    marks = [Mark(coverage.worst[: machine.space], words)]
    outlines = list(_outlines(findings))
    fields, late = panels(machine, progress), lag_panels(machine, lag, progress)
    shown: list[tuple[Quantity, Sequence[AnyPanel]]] = [
        (quantity, fields) for quantity in quantities(machine)
    ]
    if late:
        shown.append((lag_quantity(machine, lag), late))
    pictures = []
    for number, (quantity, some) in enumerate(shown):
        progress("drawing", number / len(shown))
        own = outlines if quantity.name == "margin" else []
        pictures.append((quantity, draw(quantity, some, marks, own)))
    return pictures


def _outlines(findings: Findings) -> list[Outline]:
    """The largest circle and screen, and the exact boundary of the tension capable workspace."""
    extent, found = findings.extent, []
    if extent.capable is not None and extent.capable.arcs:
        share = np.linspace(0, 1, POINTS)
        points = np.concatenate([arc.points(share) for arc in extent.capable.arcs])
        found.append(Outline(points, "tension capable workspace (exact)", CAPABLE, "--"))
    if extent.circle is not None:
        angle = np.linspace(0, 2 * np.pi, POINTS)
        around = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        found.append(_about(extent.circle, around, "largest circle served", CIRCLE))
    if extent.screen is not None:
        corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)])
        found.append(_about(extent.screen, corners, "largest screen served", SCREEN))
    return found


def _about(shape: Inscribed, points: Array, words: str, colour: str) -> Outline:
    return Outline(np.add(shape.centre, shape.half_size * points), words, colour, ":")

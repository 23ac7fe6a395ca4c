"""Draws the papers' figures into docs/figures and writes docs/figures.md."""

from pathlib import Path

from turnbuckle.lab.figures import brau, yoon, z_width
from turnbuckle.lab.figures.findings import Drawn, Finding
from turnbuckle.lab.figures.force_diagram import fig5
from turnbuckle.lab.figures.table1 import table1
from turnbuckle.model.files import write_whole
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "figures.md"
HEAD = """# The papers' figures, made again

Written by `make figures`. "Yoon" is Yoon et al. 2023, "Brau" is Brau, Lallemand and Gosselin.
"""


def stock(name: str) -> Machine:
    """A stock machine."""
    return load_machine(ROOT / "machines" / f"{name}.toml")


def draw_all() -> dict[str, list[Drawn]]:
    """All figures, by paper."""
    square = stock("brau_square")
    return {
        "Yoon": [
            yoon.fig4(stock("yoon_fixed_diagonal"), stock("yoon_fixed_orthogonal")),
            fig5((stock("yoon_fixed_diagonal"), stock("yoon2023"))),
            yoon.fig6(stock("yoon2023")),
            z_width.table1(stock("yoon2023")),
        ],
        "Brau": [
            brau.fig3(stock("brau_five")),
            *brau.fig4_and_5(square),
            brau.fig6(stock("brau_triangle")),
            brau.fig7(stock("brau_tetrahedron")),
            brau.fig8(square),
            table1(square),
        ],
    }


def page(papers: dict[str, list[Drawn]]) -> str:
    """docs/figures.md."""
    lines = [HEAD]
    for paper, figures in papers.items():
        lines += [f"## {paper}", ""]
        for drawn in figures:
            lines += [f"![{drawn.caption}](figures/{drawn.file})", "", drawn.caption, ""]
        rows = [finding for drawn in figures for finding in drawn.findings]
        lines += [*table(rows), ""]
    return "\n".join(lines)


def table(rows: list[Finding]) -> list[str]:
    """Published beside reproduced, and why they differ."""
    head = "| figure | what | published | reproduced | why they differ |"
    body = [
        f"| {row.figure} | {row.quantity} | {row.published} | {row.reproduced} | {row.why} |"
        for row in rows
    ]
    return [head, "|---|---|---|---|---|", *body]


def main() -> None:
    """Draw, write, say where."""
    write_whole(PAGE, page(draw_all()))
    print(f"{PAGE.relative_to(ROOT)} and the pictures in docs/figures")


if __name__ == "__main__":
    main()

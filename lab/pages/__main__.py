"""Writes the documentation's pages to build/pages, and the site's menu to build/mkdocs.yml."""

import json
import shutil
from pathlib import Path
from typing import Any

from turnbuckle.lab.pages.documents import copy_documents, documents, on_site
from turnbuckle.lab.pages.machine import machine_page
from turnbuckle.lab.pages.picture import draw_machine
from turnbuckle.lab.pages.reference import write_reference
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[3]
#: Titles of the menu and their pages, in order.
GUIDE = {
    "Running a machine": "running.md",
    "Buses": "buses.md",
    "Safety": "safety.md",
    "Fault campaign": "fault-campaign.md",
    "The papers' figures": "figures.md",
}
DEVELOPMENT = {
    "Architecture": "architecture.md",
    "Adding a kind": "adding-a-kind.md",
    "Adding a kind of drive": "adding-a-drive.md",
    "Adding a plant": "adding-a-plant.md",
    "Adding a fieldbus": "adding-a-fieldbus.md",
    "Adding an adapter": "adding-an-adapter.md",
    "Adding a port": "adding-a-port.md",
    "Contributing": "contributing.md",
    "Changelog": "changelog.md",
    "Licence": "licence.md",
    "Notice": "notice.md",
}
Menu = list[Any]


def write_machines(root: Path, out: Path) -> list[str]:
    """A page and a picture of every stock machine, and a page that lists them."""
    machines = [load_machine(path) for path in sorted((root / "machines").glob("*.toml"))]
    folder = out / "machines"
    folder.mkdir(parents=True)
    for machine in machines:
        (folder / f"{machine.name}.md").write_text(machine_page(machine))
        draw_machine(machine).savefig(folder / f"{machine.name}.png", metadata={"Software": None})
    (folder / "index.md").write_text(machine_list(machines))
    return ["machines/index.md", *(f"machines/{machine.name}.md" for machine in machines)]


def machine_list(machines: list[Machine]) -> str:
    """The stock machines on one page."""
    rows = [
        f"| [{m.name}]({m.name}.md) | {m.kind} | {len(m.cables)} | {len(m.rails)} | {m.source} |"
        for m in machines
    ]
    head = ["| machine | kind | cables | rails | source |", "|---|---|---|---|---|"]
    return "\n".join(["# Stock machines", "", *head, *rows]) + "\n"


def menu_of(pages: dict[str, str]) -> Menu:
    """Pages under their titles."""
    return [{title: page} for title, page in pages.items()]


def others(root: Path) -> Menu:
    """Documents without a title of their own here; the menu takes their headings."""
    pages = (str(on_site(path)) for path in documents(root) if path.suffix == ".md")
    return sorted({*pages} - {"index.md", *GUIDE.values(), *DEVELOPMENT.values()})


def write_pages(root: Path, out: Path) -> Menu:
    """Write every page of a repository to an empty folder; returns the site's menu."""
    copy_documents(root, out)
    machines = write_machines(root, out)
    reference = write_reference(root, out)
    return [
        {"Home": "index.md"},
        {"Guide": menu_of(GUIDE)},
        {"Machines": machines},
        {"Python": [page for page in reference if page.startswith("api/")]},
        {"C": [page for page in reference if page.startswith("c/")]},
        {"Development": [*menu_of(DEVELOPMENT), *others(root)]},
    ]


def main() -> None:
    """Write pages and menu, say where."""
    build = ROOT / "build"
    shutil.rmtree(build / "pages", ignore_errors=True)
    menu = write_pages(ROOT, build / "pages")
    settings = {"INHERIT": "../docs/mkdocs.yml", "nav": menu}
    (build / "mkdocs.yml").write_text(json.dumps(settings, indent=1) + "\n")
    print("pages: build/pages")


if __name__ == "__main__":
    main()

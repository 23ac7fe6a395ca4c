"""Pages of the API: every Python package by its docstrings, the C by its headers."""

from collections.abc import Iterator
from pathlib import Path

#: Folders of headers that a program of one's own includes, and what they are.
HEADERS = {
    "generated/yoon2023": "The generated C of the stock machine yoon2023",
    "runtime/core": "The runtime: controller step, supervisor, flight recorder",
    "runtime/canopen": "The runtime: CANopen master and CiA 402",
    "runtime/can": "The runtime: CAN ports",
    "runtime/port/linux": "The runtime on Linux",
}


def packages(root: Path) -> Iterator[tuple[str, list[str]]]:
    """Every package below `turnbuckle`, with its modules that have names for others."""
    for folder in ("model", "codegen", "lab"):
        for init in sorted((root / folder).rglob("__init__.py")):
            name = dotted(root, init.parent)
            modules = sorted(init.parent.glob("*.py"))
            yield name, [dotted(root, path.with_suffix("")) for path in modules if is_api(path)]


def dotted(root: Path, path: Path) -> str:
    """The name under which a package or module is imported."""
    return ".".join(("turnbuckle", *path.relative_to(root).parts))


def is_api(path: Path) -> bool:
    """Whether a module is imported, and not run."""
    return not path.stem.startswith("__")


def write_reference(root: Path, out: Path) -> list[str]:
    """Write the pages; returns their paths in the order of the menu."""
    pages = {"api/turnbuckle.md": "# turnbuckle\n\n::: turnbuckle\n"}
    for name, modules in packages(root):
        parts = [f"# {name}", *(f"::: {module}" for module in (name, *modules))]
        pages[f"api/{name}.md"] = "\n\n".join(parts) + "\n"
    for folder, title in HEADERS.items():
        pages[f"c/{folder.replace('/', '-')}.md"] = header_page(root / folder, title)
    for path, text in pages.items():
        (out / path).parent.mkdir(parents=True, exist_ok=True)
        (out / path).write_text(text)
    return list(pages)


def header_page(folder: Path, title: str) -> str:
    """The headers of a folder, each its own manual."""
    parts = [f"# {title}"]
    for path in sorted(folder.glob("*.h")):
        parts += [f"## {path.name}", f"```c\n{path.read_text()}```"]
    return "\n\n".join(parts) + "\n"

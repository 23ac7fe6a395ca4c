"""No header of the runtime includes itself, and no module imports itself, by way of others."""

import ast
import re
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
Graph = dict[str, set[str]]


def includes(folder: Path) -> Graph:
    """Which files every file of C includes, by name; names are unique in the runtime."""
    files = {path.name: path for path in folder.rglob("*.[ch]")}
    return {
        name: {found for found in INCLUDE.findall(path.read_text()) if found in files}
        for name, path in files.items()
    }


def imports(root: Path) -> Graph:
    """Which modules every module imports, at any place in it, for its types alone as well."""
    files = {
        ".".join(("turnbuckle", *path.relative_to(root).with_suffix("").parts)): path
        for folder in ("model", "codegen", "lab")
        for path in (root / folder).rglob("*.py")
        if path.stem != "__init__"
    }
    return {
        name: imported(ast.parse(path.read_text())) & files.keys() for name, path in files.items()
    }


def imported(tree: ast.Module) -> set[str]:
    """Names that may be modules."""
    names: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module:
            names |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
        elif isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
    return names


def circle(graph: Graph) -> list[str]:
    """The names along a circle; empty where there is none."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


def seeded(tmp_path: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


def test_no_header_includes_itself_by_way_of_others() -> None:
    assert len(includes(ROOT / "runtime")) > 80
    assert circle(includes(ROOT / "runtime")) == []


def test_no_module_imports_itself_by_way_of_others() -> None:
    assert sum(map(len, imports(ROOT).values())) > 400
    assert circle(imports(ROOT)) == []


def test_a_circle_of_headers_is_named(tmp_path: Path) -> None:
    files = {
        "core/a.h": '#include "b.h"\n',
        "core/b.h": '#ifdef WITH_C\n#  include "c.h"\n#endif\n',
        "port/c.h": '#include <stdint.h>\n#include "a.h"\n',
        "core/a.c": '#include "a.h"\n',
    }
    assert set(circle(includes(seeded(tmp_path, files)))) == {"a.h", "b.h", "c.h"}


@pytest.mark.parametrize(
    "line",
    [
        "from turnbuckle.model.one import x",
        "from turnbuckle.model import one",
        "import turnbuckle.model.one",
        "def f():\n    from turnbuckle.model.one import x",
        "if TYPE_CHECKING:\n    from turnbuckle.model.one import x",
    ],
)
def test_a_circle_of_modules_is_named(line: str, tmp_path: Path) -> None:
    files = {
        "model/one.py": "from turnbuckle.lab.two import y\n",
        "lab/two.py": f"{line}\n",
        "codegen/three.py": "from turnbuckle.model.one import x\n",
    }
    names = {"turnbuckle.model.one", "turnbuckle.lab.two"}
    assert set(circle(imports(seeded(tmp_path, files)))) == names

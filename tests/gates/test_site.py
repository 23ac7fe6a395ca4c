"""The documentation: links lead somewhere, code is what it says, the generator is pinned."""

import ast
import json
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest
from typer.testing import CliRunner

from turnbuckle.command_line import app
from turnbuckle.lab.pages.__main__ import DEVELOPMENT, GUIDE, write_pages
from turnbuckle.lab.pages.documents import TOP, DeadLink, copy_documents, documents, on_site

ROOT = Path(__file__).parents[2]
LINK = re.compile(r"\]\((?!https?:)([^)#\s]*)(?:#([^)\s]*))?\)")
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)
LANGUAGES = {"c", "cpp", "console", "diff", "ini", "python", "sh", "text", "toml", ""}
PIN = re.compile(r"[a-z0-9-]+==[0-9][0-9a-z.]* \\\n(?: +--hash=sha256:[0-9a-f]{64}(?: \\)?\n)+")


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """Every page of the site, as `make docs` gives it to the generator, and its menu as text."""
    folder = tmp_path_factory.mktemp("site") / "pages"
    return folder, json.dumps(write_pages(ROOT, folder))


def anchor(heading: str) -> str:
    """The place of a heading on a page."""
    words = re.sub(r"[^\w\s-]", "", heading.lower())
    return re.sub(r"[\s-]+", "-", words).strip("-")


def dead_links(pages: Path) -> set[str]:
    """Links of Markdown pages to a page, a picture or a heading that there is not."""
    dead = set()
    for page in pages.rglob("*.md"):
        for path, place in LINK.findall(BLOCK.sub("", page.read_text())):
            target = page.parent / path if path else page
            known = target.is_file() and (
                not place or place in map(anchor, HEADING.findall(target.read_text()))
            )
            if not known:
                dead.add(f"{page.relative_to(pages)}: {path}{'#' * bool(place)}{place}")
    return dead


def wrong_blocks(text: str) -> Iterator[str]:
    """Code blocks that are not of their language, and commands that there are not."""
    for language, block in BLOCK.findall(text):
        if language not in LANGUAGES:
            yield f"language {language}"
        try:
            if language == "python":
                ast.parse(block)
            if language == "toml":
                tomllib.loads(block)
        except (SyntaxError, tomllib.TOMLDecodeError) as error:
            yield f"{language}: {error}"
        if language in {"console", "sh"}:
            yield from wrong_commands(block.replace("\\\n", " "))


def wrong_commands(block: str) -> Iterator[str]:
    """Commands and options of turnbuckle, and targets of make, that there are not."""
    for name, rest in re.findall(r"^(?:\$ )?turnbuckle (\w+)(.*)$", block, re.MULTILINE):
        told = CliRunner().invoke(app, [name, "--help"])
        options = re.findall(r"(?<=\s)--[a-z-]+", rest.split("#")[0])
        yield from (
            f"turnbuckle {name} {option}"
            for option in [*options, ""]
            if told.exit_code or option not in told.stdout
        )
    makefile = (ROOT / "Makefile").read_text()
    for target in re.findall(r"^(?:\$ )?make ([a-z]+)\b", block, re.MULTILINE):
        if not re.search(rf"^{target}:", makefile, re.MULTILINE):
            yield f"make {target}"


def unpinned(lock: str) -> str:
    """What a lock holds beside pins with hashes."""
    rest = PIN.sub("", lock)
    return "\n".join(
        line for line in rest.splitlines() if line and not line.startswith("# The fol")
    )


def test_no_link_of_the_site_is_dead(site: tuple[Path, str]) -> None:
    assert dead_links(site[0]) == set()


@pytest.mark.parametrize(
    "link", ["[a](gone.md)", "![b](figures/gone.png)", "[c](running.md#gone)", "[d](#gone)"]
)
def test_a_dead_link_is_noticed(link: str, tmp_path: Path) -> None:
    (tmp_path / "running.md").write_text("# Running\n")
    (tmp_path / "page.md").write_text(f"# Page\n\n{link} [fine](running.md#running) [top](#page)\n")
    assert dead_links(tmp_path) == {f"page.md: {link.split('(')[1][:-1]}"}


def test_a_document_that_links_to_what_is_not_on_the_site_is_refused_by_name(
    tmp_path: Path,
) -> None:
    for name in TOP:
        (tmp_path / name).write_text("text\n")
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs" / "page.md").write_text("[model](../model/machine.py)\n")
    with pytest.raises(DeadLink, match=r"docs/page\.md: links to \.\./model/machine\.py"):
        copy_documents(tmp_path, tmp_path / "out")


def test_every_document_and_machine_is_on_the_site_and_in_its_menu(site: tuple[Path, str]) -> None:
    pages, menu = site
    ours = {str(on_site(path)) for path in documents(ROOT) if path.suffix in {".md", ""}}
    assert {*GUIDE.values(), *DEVELOPMENT.values()} < ours
    for page in ours:
        assert (pages / page).is_file() and f'"{page}"' in menu
    for machine in (ROOT / "machines").glob("*.toml"):
        assert f"machines/{machine.stem}.md" in menu
        picture = (pages / "machines" / f"{machine.stem}.png").read_bytes()
        assert picture.startswith(b"\x89PNG")


@pytest.mark.parametrize("path", sorted(documents(ROOT)), ids=str)
def test_code_in_the_documents_is_what_it_says(path: Path) -> None:
    if path.suffix == ".md":
        assert list(wrong_blocks((ROOT / path).read_text())) == []


@pytest.mark.parametrize(
    ("block", "told"),
    [
        ("```python\nif:\n```", "python"),
        ("```toml\n[a\n```", "toml"),
        ("```fortran\n```", "language fortran"),
        ("```console\n$ turnbuckle chekc m.toml\n```", "turnbuckle chekc"),
        ("```sh\nturnbuckle run m.toml \\\n  --simm\n```", "turnbuckle run --simm"),
        ("```sh\nmake dosc\n```", "make dosc"),
    ],
)
def test_code_that_is_not_what_it_says_is_noticed(block: str, told: str) -> None:
    assert [found for found in wrong_blocks(block) if found.startswith(told)]


def test_the_generator_of_the_site_is_pinned_by_hash() -> None:
    lock = (ROOT / "docs" / "requirements.lock").read_text()
    wanted = re.findall(r"^([a-z0-9-]+)", (ROOT / "docs" / "requirements.in").read_text(), re.M)
    assert wanted and all(f"{name}==" in lock for name in wanted)
    assert unpinned(lock) == ""


@pytest.mark.parametrize("line", ["mkdocs==1.6.1\n", "mkdocs>=1 \\\n", "--index-url somewhere\n"])
def test_a_package_without_a_hash_is_noticed(line: str) -> None:
    assert unpinned(line) == line.rstrip()

"""The repository's documents as pages of the site, with links that lead there too."""

import re
import shutil
from pathlib import Path, PurePosixPath

from turnbuckle.model.refusal import Refusal

#: Documents beside docs/ and what they are called on the site; docs/ keeps its names.
TOP = {
    "README.md": "index.md",
    "CHANGELOG.md": "changelog.md",
    "CONTRIBUTING.md": "contributing.md",
    "LICENSE": "licence.md",
    "NOTICE": "notice.md",
}
LINK = re.compile(r"(?<=\]\()(?P<path>[^)#\s]*)(?P<place>#[^)\s]*)?(?=\))")
FENCE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)


class DeadLink(Refusal):
    """A document links to what is not on the site."""


def copy_documents(root: Path, out: Path) -> None:
    """Write the documents and pictures of a repository to a folder of pages; DeadLink."""
    for path in sorted(documents(root)):
        target = out / on_site(path)
        target.parent.mkdir(parents=True, exist_ok=True)
        if path.suffix == ".md":
            target.write_text(relinked(root, path))
        elif path.suffix:
            shutil.copyfile(root / path, target)
        else:
            target.write_text(
                f"# {path.name.capitalize()}\n\n```text\n{(root / path).read_text()}```\n"
            )


def documents(root: Path) -> list[PurePosixPath]:
    """What becomes of the site, by its path in the repository."""
    docs = [
        PurePosixPath(path.relative_to(root).as_posix())
        for path in (root / "docs").rglob("*")
        if path.suffix in {".css", ".json", ".md", ".png"}
    ]
    return [*map(PurePosixPath, TOP), *docs]


def on_site(path: PurePosixPath) -> PurePosixPath:
    """Where a document is on the site."""
    return PurePosixPath(TOP.get(str(path)) or path.relative_to("docs"))


def relinked(root: Path, path: PurePosixPath) -> str:
    """A document's text, its links as they are between pages; code is left alone."""
    known = {document: on_site(document) for document in documents(root)}
    text = (root / path).read_text()

    def target(match: re.Match[str]) -> str:
        if not match["path"] or ":" in match["path"]:
            return match[0]
        linked = normal(path.parent / match["path"])
        if linked not in known:
            raise DeadLink(f"{path}: links to {match['path']}; there is no such page")
        return relative(known[linked], on_site(path)) + (match["place"] or "")

    code = FENCE.findall(text)
    prose = [LINK.sub(target, part) for part in FENCE.split(text)]
    return "".join(a + b for a, b in zip(prose, [*code, ""], strict=True))


def normal(path: PurePosixPath) -> PurePosixPath:
    """The path without `..`."""
    parts: list[str] = []
    for part in path.parts:
        if part == "..":
            parts = parts[:-1]
        else:
            parts.append(part)
    return PurePosixPath(*parts)


def relative(target: PurePosixPath, page: PurePosixPath) -> str:
    """A link from one page to another."""
    return "../" * (len(page.parts) - 1) + str(target)

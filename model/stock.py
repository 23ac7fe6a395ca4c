"""The stock machines, which come with Turnbuckle and are known by name."""

from pathlib import Path

from turnbuckle.places import MACHINES


def stock_names() -> list[str]:
    """Their names, in alphabetical order."""
    return sorted(path.stem for path in MACHINES.glob("*.toml"))


def machine_file(path: str | Path) -> Path:
    """The file that a user names: by its path or, where there is none, as a stock machine."""
    path = Path(path)
    stock = MACHINES / f"{path}.toml"
    return stock if str(path) in stock_names() and not _is_file(path) else path


def _is_file(path: Path) -> bool:
    return path.exists() and not path.is_dir()

"""The generated C as Python functions: NumPy in and out, SI units, batches looped in C."""

import ctypes
import hashlib
import json
from collections import namedtuple
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import jinja2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from turnbuckle.codegen.compile import LIBRARIES, compile_library
from turnbuckle.codegen.folder import FolderError
from turnbuckle.codegen.generate import MANIFEST, TEMPLATES, generate, write
from turnbuckle.model.files import write_whole
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.symbolic.function import Status

REALS: dict[str, type[np.floating[Any]]] = {"double": np.float64, "float": np.float32}


class Values(np.ndarray[Any, Any]):
    """An array with the status of the call: a `Status`, or an array of them for a batch."""

    status: Any = Status.OK

    def __array_finalize__(self, source: Any) -> None:
        self.status = getattr(source, "status", Status.OK)


@dataclass(frozen=True)
class Port:
    """An argument or result."""

    name: str
    shape: tuple[int, ...]
    unit: str

    @property
    def size(self) -> int:
        """Number of entries."""
        return int(np.prod(self.shape, dtype=int))


class GeneratedFunction:
    """One generated function."""

    def __init__(
        self, name: str, inputs: list[Port], outputs: list[Port], library: ctypes.CDLL, real: Any
    ) -> None:
        self.name, self.inputs, self.outputs, self._real = name, inputs, outputs, real
        self._call = library[f"batch_{name}"]
        self._call.restype = None
        title = "".join(part.capitalize() for part in name.split("_"))
        fields = [*(port.name for port in outputs), "status"]
        self._result: Any = namedtuple(title, fields)  # type: ignore[misc]
        self.__name__ = name
        self.__doc__ = f"{self.signature()}: shapes without the batch axes; see the C header."

    def signature(self) -> str:
        """Arguments and results with units and shapes."""
        inputs = ", ".join(f"{p.name} [{p.unit}] {p.shape}" for p in self.inputs)
        outputs = ", ".join(f"{p.name} [{p.unit}] {p.shape}" for p in self.outputs)
        return f"{self.name}({inputs}) -> {outputs}"

    def __call__(self, *arguments: ArrayLike, **named: ArrayLike) -> Any:
        """Evaluate. Leading axes are a batch; an argument without them serves the whole batch."""
        given = self._arrays(self._by_position(arguments, named))
        lead = np.broadcast_shapes(*(a.shape[: a.ndim - len(p.shape)] for a, p in given))
        count = int(np.prod(lead, dtype=int))
        outputs = [np.empty(lead + port.shape, self._real) for port in self.outputs]
        status = np.empty(lead, np.intc)
        passed: list[Any] = [ctypes.c_size_t(count)]
        alive = []
        for array, port in given:
            single = array.ndim == len(port.shape)
            full = array if single else np.broadcast_to(array, lead + port.shape)
            alive.append(np.ascontiguousarray(full))
            passed += [pointer(alive[-1]), ctypes.c_size_t(0 if single else port.size)]
        self._call(*passed, *map(pointer, outputs), pointer(status))
        return self._pack(outputs, status)

    def _by_position(
        self, arguments: tuple[ArrayLike, ...], named: dict[str, ArrayLike]
    ) -> list[ArrayLike]:
        """Arguments in order; those without entries (rails of fixed bases) may be missing."""
        values: dict[str, ArrayLike] = dict(
            zip((port.name for port in self.inputs), arguments, strict=False)
        )
        unknown = named.keys() - {port.name for port in self.inputs}
        if unknown or len(arguments) > len(self.inputs) or values.keys() & named.keys():
            raise TypeError(f"{self.signature()}: got {len(arguments)} arguments and {list(named)}")
        values |= named
        for port in self.inputs:
            if port.name not in values:
                if port.size:
                    raise TypeError(f"{self.signature()}: {port.name} is missing")
                values[port.name] = np.zeros(port.shape)
        return [values[port.name] for port in self.inputs]

    def _arrays(self, values: list[ArrayLike]) -> list[tuple[NDArray[Any], Port]]:
        """Arguments as arrays of the right precision and shape."""
        pairs = []
        for value, port in zip(values, self.inputs, strict=True):
            array = np.asarray(value, dtype=self._real)
            tail = (
                array.shape[array.ndim - len(port.shape) :]
                if array.ndim >= len(port.shape)
                else None
            )
            if tail != port.shape:
                raise ValueError(
                    f"{self.name}: {port.name} has shape {array.shape}; "
                    f"it takes {port.shape}, after any batch axes"
                )
            pairs.append((array, port))
        return pairs

    def _pack(self, outputs: list[NDArray[Any]], status: NDArray[np.intc]) -> Any:
        answer: Any = Status(int(status)) if status.ndim == 0 else status
        if len(outputs) > 1:
            return self._result(*outputs, answer)
        values = outputs[0].view(Values)
        values.status = answer
        return values


def pointer(array: NDArray[Any]) -> ctypes.c_void_p:
    """Address of the first entry."""
    return ctypes.c_void_p(array.ctypes.data)


class Generated:
    """All functions of one machine: `c.cable_lengths(pose, rails)` and so on."""

    def __init__(
        self, machine: Machine, folder: Path, precision: str, archive: Path | None = None
    ) -> None:
        """Compile the C in a folder, or link what was compiled of it into a static library."""
        self.machine, self.folder, self.precision = machine, folder, precision
        content = json.loads((folder / MANIFEST).read_text())
        self.hash: str = content["hash"]
        self.library = compile_library(
            [
                batch_source(folder, content),
                *([archive] if archive else sorted(folder.glob("*.c"))),
            ],
            [folder],
            precision,
        )
        loaded = ctypes.CDLL(str(self.library))
        self.functions = {
            name: GeneratedFunction(name, inputs, outputs, loaded, REALS[precision])
            for name, inputs, outputs in signatures(content)
        }

    def __getattr__(self, name: str) -> Callable[..., Any]:
        functions = self.__dict__.get("functions", {})
        if name not in functions:
            raise AttributeError(f"{name!r} is not generated; there are {', '.join(functions)}")
        function: GeneratedFunction = functions[name]
        return function

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.functions]


def signatures(content: dict[str, Any]) -> Iterator[tuple[str, list[Port], list[Port]]]:
    """Name, arguments and results of every function in a manifest, aliases included."""
    functions = content["functions"]
    targets = {name: name for name in functions} | content["aliases"]
    for name, target in targets.items():
        inputs, outputs = (
            [Port(p["name"], tuple(p["shape"]), p["unit"]) for p in functions[target][side]]
            for side in ("inputs", "outputs")
        )
        yield name, inputs, outputs


def batch_source(folder: Path, content: dict[str, Any]) -> Path:
    """C that loops over a batch, for the functions of a manifest."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        undefined=jinja2.StrictUndefined,
        autoescape=False,
    )
    headers = {
        name.removesuffix(".c").removeprefix("tb_")
        for name in content["files"]
        if name.endswith(".c")
    }
    functions = [
        {"name": name, "inputs": inputs, "outputs": outputs}
        for name, inputs, outputs in signatures(content)
    ]
    text = environment.get_template("batch.c.jinja").render(
        topics=sorted(headers), functions=functions
    )
    path = LIBRARIES / f"batch_{hashlib.sha256(text.encode()).hexdigest()[:16]}.c"
    if not path.exists():
        write_whole(path, text)
    return path


def generate_into_cache(machine: Machine) -> Path:
    """A generated folder of the machine in the cache, one for every content, made once."""
    return folder_of(machine, generate(machine))


def folder_of(machine: Machine, files: dict[str, str]) -> Path:
    """The folder in the cache that holds these files of a machine."""
    digest = hashlib.sha256(json.dumps(files, sort_keys=True).encode()).hexdigest()[:16]
    folder = LIBRARIES.parent / "generated" / f"{machine.name}-{digest}"
    if not (folder / MANIFEST).exists():
        try:
            write(files, folder)
        except FolderError:
            # Another process that made the same folder meanwhile is no failure.
            if not (folder / MANIFEST).exists():
                raise
    return folder


def load(machine_file: str | Path, precision: str = "double") -> Generated:
    """Generate, compile and load the C of a machine file.

    precision: "double" or "float". Raises MachineError for a bad file, CompileError where there is
    no working C compiler, ValueError for an unknown precision.
    """
    machine = load_machine(machine_file)
    return Generated(machine, generate_into_cache(machine), precision)

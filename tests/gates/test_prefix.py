"""Two complete controllers in one program: every name of theirs begins with a prefix."""

import ctypes
import json
import re
import subprocess
from pathlib import Path

import pytest

import turnbuckle.lab.lockstep
from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.bind import REALS, Generated, GeneratedFunction, batch_source, signatures
from turnbuckle.codegen.compile import compiled
from turnbuckle.codegen.generate import MANIFEST, render, write
from turnbuckle.codegen.hard_cases import HardSampler
from turnbuckle.codegen.model import Model
from turnbuckle.codegen.prefix import (
    KEYWORDS,
    PrefixError,
    file_name,
    prefixed,
    refuse_prefix,
    renamed,
    runtime_files,
)
from turnbuckle.codegen.verify import call
from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.lockstep import SHIM, Lockstep, State
from turnbuckle.lab.machine_sim import SimulatedMachine
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]
CORE, CANOPEN, CAN = (ROOT / "runtime" / part for part in ("core", "canopen", "can"))
DOCUMENT = ROOT / "docs" / "targets.md"
POINTS = 1000
WARNINGS = ("-Wall", "-Wextra", "-Wpedantic", "-Werror")
#: What a program does with one of its machines, as text of a machine without a prefix.
SHOW = """
#include <stdio.h>

#include "tb_loopback.h"
#include "tb_master.h"
#include "tb_network.h"

static tb_loopback buses[TB_BUSES];
static tb_network network;
static tb_master master;

#ifdef __cplusplus
extern "C" {
#endif
void tb_show(void);
#ifdef __cplusplus
}
#endif

void tb_show(void)
{
    static tb_wishes wishes;
    tb_can_port *ports[TB_BUSES];
    tb_can_frame frame;
    for (int i = 0; i < TB_BUSES; i++) {
        tb_loopback_open(&buses[i]);
        ports[i] = &buses[i].port;
    }
    tb_network_start(&network, ports);
    tb_master_start(&master, &network.fieldbus);
    for (int cycle = 0; cycle < 8; cycle++) {
        tb_master_sync(&master);
        tb_master_run(&master, &wishes, 0);
        for (int i = 0; i < TB_BUSES; i++) {
            while (tb_loopback_take(&buses[i], &frame) == TB_CAN_OK) {
                printf("%s %d: %03x %d\\n", TB_MACHINE_NAME, i, (unsigned)frame.id,
                       (int)frame.length);
            }
        }
    }
    printf("%s: state %d\\n", TB_MACHINE_NAME, (int)master.orders.state);
}
"""
BOTH = """
#include "left_control.h"
#include "left_tension.h"
#include "right_control.h"
#include "right_tension.h"
#ifdef __cplusplus
extern "C" {
#endif
void left_show(void);
void right_show(void);
#ifdef __cplusplus
}
#endif
int main(void)
{
    left_show();
    right_show();
    return LEFT_OK + RIGHT_OK;
}
"""


def committed(name: str) -> dict[str, str]:
    """The committed C of a machine."""
    folder = ROOT / "generated" / name
    return {path.name: path.read_text() for path in folder.iterdir() if path.name != MANIFEST}


def folder_of(name: str, prefix: str, to: Path) -> Path:
    """A machine's C with its runtime under a prefix."""
    machine = load_machine(ROOT / "machines" / f"{name}.toml")
    files = prefixed(committed(name) | runtime_files(machine, "/* a test */"), prefix)
    (to / prefix / "linux").mkdir(parents=True)
    for file, text in files.items():
        (to / prefix / file).write_text(text)
    return to / prefix


@pytest.fixture(scope="module")
def machines(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """yoon2023 as left, spidar_g as right."""
    to = tmp_path_factory.mktemp("prefixed")
    return {
        prefix: folder_of(name, prefix, to)
        for prefix, name in (("left", "yoon2023"), ("right", "spidar_g"))
    }


def sources_of(folder: Path) -> list[Path]:
    """All C of a prefixed machine, its Linux adapters too."""
    return [*sorted(folder.glob("*.c")), *sorted(folder.glob("linux/*.c"))]


def object_of(sources: list[Path], include: list[Path]) -> Path:
    """Some sources as one object, in which a name that is there twice is an error."""
    return compiled(sources, include, "double", ("-r", "-nostdlib", *WARNINGS), ".o")


@pytest.fixture(scope="module")
def objects(machines: dict[str, Path]) -> dict[str, Path]:
    """Both machines, compiled."""
    return {
        prefix: object_of(sources_of(folder), [folder, folder / "linux"])
        for prefix, folder in machines.items()
    }


def external(product: Path) -> list[str]:
    """Names that an object gives to others."""
    command = ["nm", "--defined-only", "--extern-only", "--format=posix", str(product)]
    listed = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return [line.split()[0] for line in listed.splitlines()]


def without(prefix: str, product: Path) -> list[str]:
    """Names that an object gives to others and that do not begin with the prefix."""
    return [name for name in external(product) if not name.startswith(f"{prefix}_")]


@pytest.mark.parametrize("prefix", ["left", "right"])
def test_every_external_name_has_the_prefix(prefix: str, objects: dict[str, Path]) -> None:
    assert len(external(objects[prefix])) > 150
    assert without(prefix, objects[prefix]) == []


def test_a_name_without_the_prefix_is_noticed(machines: dict[str, Path], tmp_path: Path) -> None:
    seeded = tmp_path / "seeded.c"
    statics = (machines["left"] / "left_statics.c").read_text()
    seeded.write_text(f"{statics}\nint tb_seeded(void);\nint tb_seeded(void) {{ return 0; }}\n")
    assert without("left", object_of([seeded], [machines["left"]])) == ["tb_seeded"]


@pytest.mark.parametrize("kind", ["*.[ch]", "linux/*.[ch]"])
def test_no_name_and_no_file_of_old_is_left(kind: str, machines: dict[str, Path]) -> None:
    for prefix, folder in machines.items():
        files = list(folder.glob(kind))
        assert files
        assert all(file.name.startswith(f"{prefix}_") for file in files)
        old = re.compile(r"\b(tb_\w+|TB_\w+|real_t)\b")
        assert not {file.name: found for file in files if (found := old.findall(file.read_text()))}


def header_names(folder: Path) -> list[str]:
    """Headers of a prefixed machine."""
    return sorted(path.name for path in folder.rglob("*.h"))


@pytest.mark.parametrize(
    ("compiler", "standard"),
    [("gcc", "c99"), ("clang", "c11"), ("g++", "c++11"), ("clang++", "c++20")],
)
@pytest.mark.parametrize("precision", ["-ULEFT_REAL_FLOAT", "-DLEFT_REAL_FLOAT"])
def test_all_headers_of_both_go_into_one_file(
    compiler: str, standard: str, precision: str, machines: dict[str, Path]
) -> None:
    folders = [each for folder in machines.values() for each in (folder, folder / "linux")]
    names = [name for folder in machines.values() for name in header_names(folder)]
    source = "".join(f'#include "{name}"\n' for name in names)
    language = "c++" if standard.startswith("c++") else "c"
    command = [compiler, f"-x{language}", f"-std={standard}", *WARNINGS, precision]
    command += [*(f"-I{each}" for each in folders), "-fsyntax-only", "-"]
    done = subprocess.run(command, input=source, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


def test_without_prefixes_two_machines_do_not_link() -> None:
    folders = [ROOT / "generated" / name for name in ("yoon2023", "spidar_g")]
    sources = [folder / "tb_statics.c" for folder in folders]
    done = subprocess.run(
        ["gcc", "-r", "-nostdlib", *map(str, sources), "-o", "/dev/null"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert "multiple definition of `tb_wrench'" in done.stderr


def shown(compiler: str, suffix: str, machines: dict[str, Path], objects: list[Path]) -> str:
    """What the program with both machines prints."""
    folder = machines["left"].parent / suffix
    folder.mkdir()
    for prefix, include in machines.items():
        names = header_names(include)
        text = renamed(SHOW, prefix, [f"tb_{name.removeprefix(f'{prefix}_')}" for name in names])
        (folder / f"{prefix}_show.{suffix}").write_text(text)
    (folder / f"main.{suffix}").write_text(BOTH)
    command = [compiler, *WARNINGS, *(f"-I{each}" for each in machines.values())]
    command += [*map(str, folder.glob(f"*.{suffix}")), *map(str, objects), "-lm"]
    done = subprocess.run(
        [*command, "-o", str(folder / "both")], capture_output=True, text=True, check=False
    )
    assert done.stderr == ""
    return subprocess.run([folder / "both"], capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize(("compiler", "suffix"), [("gcc", "c"), ("g++", "cpp")])
def test_two_machines_run_in_one_program(
    compiler: str, suffix: str, machines: dict[str, Path], objects: dict[str, Path]
) -> None:
    printed = shown(compiler, suffix, machines, list(objects.values()))
    for name, buses in (("yoon2023", 3), ("spidar_g", 4)):
        lines = [line for line in printed.splitlines() if line.startswith(name)]
        assert lines[-1] == f"{name}: state {int(State.INIT)}"
        synced = {line.split(":")[0] for line in lines if ": 080 0" in line}
        assert synced == {f"{name} {bus}" for bus in range(buses)}


def test_the_program_of_the_document_runs(
    machines: dict[str, Path], objects: dict[str, Path], tmp_path: Path
) -> None:
    (source,) = re.findall(r"^```cpp\n(.*?)^```", DOCUMENT.read_text(), re.MULTILINE | re.DOTALL)
    (tmp_path / "two.cpp").write_text(source)
    command = ["g++", "-std=c++11", *WARNINGS, *(f"-I{folder}" for folder in machines.values())]
    command += [str(tmp_path / "two.cpp"), *map(str, objects.values()), "-o", str(tmp_path / "two")]
    done = subprocess.run([*command, "-lm"], capture_output=True, text=True, check=False)
    assert done.stderr == ""
    done = subprocess.run([tmp_path / "two"], capture_output=True, text=True, check=True)
    assert done.stdout == "yoon2023: status 0, spidar_g: status 0\n"


def prefixed_functions(
    folder: Path, prefix: str, generated: Generated
) -> dict[str, GeneratedFunction]:
    """The functions of a prefixed machine for Python, like those of the plain one."""
    content = json.loads((generated.folder / MANIFEST).read_text())
    batch = folder.parent / f"batch_{prefix}.c"
    plain = batch_source(generated.folder, content).read_text()
    batch.write_text(renamed(plain, prefix, content["files"]))
    sources = [folder / file_name(name, prefix) for name in content["files"] if name.endswith(".c")]
    precision = (f"-D{prefix.upper()}_REAL_FLOAT",) if generated.precision == "float" else ()
    library = compiled(
        [*sources, batch], [folder], "double", ("-shared", "-fPIC", *precision), ".so"
    )
    loaded = ctypes.CDLL(str(library))
    real = REALS[generated.precision]
    return {
        name: GeneratedFunction(name, inputs, outputs, loaded, real)
        for name, inputs, outputs in signatures(content)
    }


@pytest.mark.parametrize(
    ("prefix", "name", "precision"),
    [
        ("left", "yoon2023", "double"),
        ("left", "yoon2023", "float"),
        ("right", "spidar_g", "double"),
    ],
)
def test_the_prefix_changes_no_bit_of_a_result(
    prefix: str, name: str, precision: str, machines: dict[str, Path]
) -> None:
    machine = load_machine(ROOT / "machines" / f"{name}.toml")
    plain = Generated(machine, ROOT / "generated" / name, precision)
    functions = prefixed_functions(machines[prefix], prefix, plain)
    sampler = HardSampler(machine, 71, POINTS)
    for function, one in plain.functions.items():
        arguments = [
            sampler.argument(function, p.name, p.size).reshape(POINTS, *p.shape) for p in one.inputs
        ]
        wanted, given = (call(each, arguments) for each in (one, functions[function]))
        assert (wanted["status"] == 0).any()
        for output, values in wanted.items():
            assert values.tobytes() == given[output].tobytes(), f"{function}.{output}"


def views(generated: Generated, cycles: int) -> list[bytes]:
    """What there is to see of every cycle on the way to work and at it, on simulated drives."""
    machine = generated.machine
    lockstep = Lockstep(
        generated, SimulatedMachine(machine, plant_of(machine), plan_task(generated))
    )
    seen: list[bytes] = []
    lockstep.taps.append(lambda bus, frame: seen.append(repr((bus, frame)).encode()))
    lockstep.bring_up(cycles)
    lockstep.run(200)
    seen.append(lockstep.view.tobytes())
    return seen


def test_the_prefix_changes_no_frame_of_the_whole_runtime(
    double: Generated, machines: dict[str, Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    wanted = views(double, 3000)
    left, load = machines["left"], turnbuckle.lab.lockstep.load
    shim = left.parent / "shim.c"
    names = [path.name for part in (CORE, CANOPEN, CAN) for path in part.glob("*.h")]
    shim.write_text(renamed(SHIM.read_text(), "left", names))

    def load_prefixed(generated: Generated) -> ctypes.CDLL:
        with monkeypatch.context() as exchanged:
            exchanged.setattr(turnbuckle.lab.lockstep, "PORTABLE_CAN", ())
            exchanged.setattr(turnbuckle.lab.lockstep, "SHIM", shim)
            exchanged.setattr(generated, "folder", left)
            return load(generated, ())

    monkeypatch.setattr(turnbuckle.lab.lockstep, "load", load_prefixed)
    given = views(double, 3000)
    assert len(wanted) > 5_000
    assert given == wanted


def test_what_needs_no_operating_system_compiles_for_a_microcontroller(
    machines: dict[str, Path],
) -> None:
    arm = ["arm-none-eabi-gcc", "-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard"]
    arm += ["-mfpu=fpv4-sp-d16"]
    sources = sorted(machines["left"].glob("*.c"))
    for chosen, fails in ((sources, False), (sources_of(machines["left"]), True)):
        command = [*arm, "-std=c11", "-fsyntax-only", f"-I{machines['left']}", *map(str, chosen)]
        done = subprocess.run(
            [*command, f"-I{machines['left'] / 'linux'}"], capture_output=True, check=False
        )
        assert (done.returncode != 0) == fails


def test_a_machine_without_buses_takes_the_step_alone(tmp_path: Path) -> None:
    machine = load_machine(ROOT / "machines" / "brau_square.toml")
    assert not machine.buses
    files = prefixed(committed("brau_square") | runtime_files(machine, "/* a test */"), "left")
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    product = object_of(sorted(tmp_path.glob("*.c")), [tmp_path])
    assert "left_controller_step" in external(product)
    undefined = subprocess.run(
        ["nm", "--undefined-only", str(product)], capture_output=True, text=True, check=True
    ).stdout
    assert not re.search(r"\b(left|tb)_", undefined)


@pytest.mark.parametrize(
    "prefix",
    [
        "",
        "x",
        "tb",
        "Left",
        "left_arm",
        "_left",
        "2nd",
        "lefté",
        "a" * 17,
        "le ft",
        *sorted(KEYWORDS),
    ],
)
def test_a_prefix_that_c_does_not_allow_is_refused_in_one_sentence(prefix: str) -> None:
    with pytest.raises(PrefixError, match=f'--prefix: found "{prefix}"; allowed: 2 to 16 lower'):
        refuse_prefix(prefix)


def words_of_the_system() -> set[str]:
    """Names and macros in the headers that the runtime includes, and some more."""
    text = "".join(
        path.read_text() for part in (CORE, CANOPEN, CAN) for path in part.glob("*.[ch]")
    )
    names = {*re.findall(r"#include (<.*>)", text), "<stdio.h>", "<stdlib.h>", "<pthread.h>"}
    names |= {"<inttypes.h>", "<limits.h>", "<signal.h>", "<math.h>", "<float.h>", "<threads.h>"}
    source = "".join(f"#include {name}\n" for name in sorted(names))
    words: set[str] = set()
    for option in ("-dD", "-P"):
        command = ["gcc", "-D_GNU_SOURCE", "-E", option, "-"]
        done = subprocess.run(command, input=source, capture_output=True, text=True, check=True)
        words |= set(re.findall(r"\w+", done.stdout))
    return words


def is_refused(prefix: str) -> bool:
    """Whether the command refuses a prefix."""
    try:
        refuse_prefix(prefix)
    except PrefixError:
        return True
    return False


def test_no_prefix_makes_a_name_of_the_c_library() -> None:
    ours = set(re.findall(r"\b(?:tb|TB)_\w+", "".join(committed("yoon2023").values())))
    for part in (CORE, CANOPEN, CAN):
        for path in part.glob("*.[ch]"):
            ours |= set(re.findall(r"\b(?:tb|TB)_\w+", path.read_text()))
    lower, upper = ({word[3:] for word in ours if word[:2] == kind} for kind in ("tb", "TB"))
    clashing = set()
    for word in words_of_the_system():
        first, _, rest = word.partition("_")
        if (first.islower() and rest in lower) or (first.isupper() and rest in upper):
            clashing.add(first.lower())
    assert {"flt", "int8", "tm"} <= clashing
    assert not {prefix for prefix in clashing if not is_refused(prefix)}


def test_a_prefix_that_makes_a_name_the_c_has_is_refused() -> None:
    files = {"tb_a.c": "int tb_lengths(int cable_lengths);\n"}
    assert list(prefixed(files, "left")) == ["left_a.c"]
    with pytest.raises(PrefixError, match="cable_lengths, which the C has already"):
        prefixed(files, "cable")


def test_texts_stay_and_comments_follow() -> None:
    text = (
        '#include "torque_gate.h"\n/* tb_x: torque_gate.h */ char *tb_x = "tb_x /*", y = \'"\';\n'
    )
    assert renamed(text, "left", ["torque_gate.h"]) == (
        '#include "left_torque_gate.h"\n'
        '/* left_x: left_torque_gate.h */ char *left_x = "tb_x /*", y = \'"\';\n'
    )


def test_the_manifest_and_every_file_say_how_it_was_made(
    stock: Machine, stock_model: Model, stock_accuracies: dict[str, Accuracy], tmp_path: Path
) -> None:
    plain = render(stock_model, stock_accuracies)
    files = render(stock_model, stock_accuracies, "left")
    manifest = json.loads(files[MANIFEST])
    assert (manifest["prefix"], json.loads(plain[MANIFEST])["prefix"]) == ("left", "tb")
    assert manifest["hash"] == json.loads(plain[MANIFEST])["hash"]
    again = "machines/yoon2023.toml --prefix left --out <this folder>\n"
    assert all(
        again in text.split("*/")[0] for name, text in files.items() if name[-2:] in (".c", ".h")
    )
    write(files, tmp_path / "left")
    write(files, tmp_path / "left")
    found = {path: path.read_text() for path in (tmp_path / "left").rglob("*") if path.is_file()}
    assert {
        path.relative_to(tmp_path / "left").as_posix(): text for path, text in found.items()
    } == files

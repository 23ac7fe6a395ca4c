"""`turnbuckle image` and `flash`: OpenOCD programs the simulated chip, which then runs it."""

import re
import shlex
import socket
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from compiled_firmware import report
from flashed import FLAGS, MARK_OF_A_DAMAGED_IMAGE, at_a_probe, image, linked
from stm32g474 import Chip
from stm32g474.debug import Debug
from stm32g474.flash import PAGE, SEALED
from stm32g474.peripheral import Access, Register
from typer.testing import CliRunner, Result

from turnbuckle.command_line import app
from turnbuckle.lab.boards import session
from turnbuckle.lab.boards.chip import CHIPS, STM32G474
from turnbuckle.lab.boards.record import read_image

ROOT = Path(__file__).parents[2]
MACHINE = str(ROOT / "machines" / "yoon2023.toml")
BOOT = 200_000_000
"""Longer than the check of the CRC takes [ns]."""
OLD = 3_000
"""Bytes of the program that is in the chip before."""


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """Images of the board, each built once."""
    folder = tmp_path_factory.mktemp("images")
    return lambda **what: image(folder, **what)


@pytest.fixture
def chip(built: Callable[..., Path]) -> Chip:
    """A chip that runs an older and smaller program of the machine."""
    _, content = read_image(built(weight=OLD))
    return Chip(content, faults="take")


def flash(file: Path, probe: Path | str, *more: str) -> Result:
    """Do the command."""
    words = ["flash", MACHINE, f"--image={file}", f"--probe={probe}", *more]
    return CliRunner().invoke(app, words)


def message(result: Result) -> str:
    """The one message of a command that cannot do what it was asked for."""
    assert result.exit_code == 2, result.output
    assert result.stderr.count("\n") == 1 and "Traceback" not in result.stderr
    return result.stderr


def runs(chip: Chip) -> bool:
    """Whether the program in the chip starts and works."""
    chip.reset("power")
    chip.run_for(BOOT)
    before = report(chip, 0)
    chip.run_for(1_000_000)
    return report(chip, 1) != MARK_OF_A_DAMAGED_IMAGE and report(chip, 0) > before


def test_what_was_flashed_is_verified_and_runs(
    chip: Chip, built: Callable[..., Path], tmp_path: Path
) -> None:
    _, content = read_image(built())
    with at_a_probe(chip, tmp_path) as (server, probe):
        result = flash(built(), probe)
        assert result.exit_code == 0, result.output
        assert server.port.refused == []
    assert chip.flash[: len(content)] == content
    assert result.stdout.splitlines()[-1] == "stm32g474: written, verified and started"
    assert re.search(r"^before +yoon2023 \w+, float, Turnbuckle", result.stdout, re.MULTILINE)
    assert not chip.halted
    chip.run_for(BOOT)
    count = report(chip, 0)
    chip.run_for(1_000_000)
    assert report(chip, 0) > count


def test_an_image_of_another_length_is_flashed_over_a_longer_one(
    built: Callable[..., Path], tmp_path: Path
) -> None:
    _, longer = read_image(built())
    chip = Chip(longer, faults="take")
    with at_a_probe(chip, tmp_path) as (_, probe):
        assert flash(built(weight=OLD), probe).exit_code == 0
    assert runs(chip)


def erasing(page: int) -> Callable[[Chip], bool]:
    """While a page is being erased."""
    return lambda chip: chip.flash_controller.working_on == (page * PAGE, PAGE)


def written(place: int) -> Callable[[Chip], bool]:
    """As soon as something is at a place that was erased before."""
    erased = False

    def cut(chip: Chip) -> bool:
        nonlocal erased
        here = chip.flash[place : place + 8] == b"\xff" * 8
        erased = erased or here
        return erased and not here

    return cut


MOMENTS = {
    "the first page is being erased": (erasing(0), "erased"),
    "the second page is being erased": (erasing(1), "erased"),
    "the last page is being erased": (erasing(7), "erased"),
    "the second page is being written": (written(PAGE), "written"),
    "the last page is being written": (written(7 * PAGE), "written"),
    "the vectors are being written": (written(0), "written"),
}
SMALL = 14_000
"""Bytes of an image of eight pages."""


@pytest.mark.parametrize("moment", MOMENTS)
def test_a_cut_of_power_leaves_nothing_that_starts_and_is_mended_by_the_command_told(
    moment: str, chip: Chip, built: Callable[..., Path], tmp_path: Path
) -> None:
    cut, doing = MOMENTS[moment]
    with at_a_probe(chip, tmp_path, cut, returns=True) as (_, probe):
        told = message(flash(built(weight=SMALL), probe))
    assert not runs(chip)
    assert f"stopped while its flash was being {doing}" in told
    assert "in the chip now: " in told
    assert not re.search("in the chip now: yoon2023", told)
    again = shlex.split(re.split("do it again: turnbuckle ", told)[1])
    second = tmp_path / "second"
    second.mkdir()
    with at_a_probe(chip, second) as (_, probe):
        mended = [*again[:-1], f"--probe={probe}"]
        assert CliRunner().invoke(app, mended).exit_code == 0
    assert runs(chip)


def test_a_chip_that_stays_without_power_is_told_to_be_so(
    chip: Chip, built: Callable[..., Path], tmp_path: Path
) -> None:
    with at_a_probe(chip, tmp_path, written(PAGE)) as (_, probe):
        told = message(flash(built(weight=SMALL), probe))
    assert "what is in the chip now cannot be read" in told


def test_a_chip_without_power_is_not_reached(built: Callable[..., Path], tmp_path: Path) -> None:
    chip = Chip(b"", faults="take")
    chip.power_cut()
    with at_a_probe(chip, tmp_path) as (_, probe):
        told = message(flash(built(), probe))
    assert "does not answer the probe" in told and "the program in the chip was not changed" in told


def test_what_the_memory_does_not_keep_is_seen_by_the_verification(
    chip: Chip, built: Callable[..., Path], tmp_path: Path
) -> None:
    _, content = read_image(built(weight=SMALL))
    place = content.index(FLAGS.encode())

    def weak(chip: Chip) -> bool:
        if chip.flash[place] != 0xFF:
            chip.processor.flash[place] &= 0xFE  # this bit does not stay one
        return False

    assert content[place] & 1
    with at_a_probe(chip, tmp_path, weak) as (_, probe):
        told = message(flash(built(weight=SMALL), probe))
    assert "what is in its flash is not what was sent" in told
    assert "a damaged image of yoon2023" in told
    assert not runs(chip)


@pytest.mark.parametrize(
    ("protection", "word"), [(0xBB, "stm32l4x unlock 0"), (SEALED, "for good")]
)
def test_a_locked_chip_is_left_alone(
    protection: int, word: str, chip: Chip, built: Callable[..., Path], tmp_path: Path
) -> None:
    before = chip.flash
    chip.flash_controller.read_protection = protection
    chip.reset("power")
    with at_a_probe(chip, tmp_path) as (_, probe):
        told = message(flash(built(), probe))
    assert word in told and "not changed" in told
    assert chip.flash == before


def test_another_chip_is_left_alone(
    chip: Chip, built: Callable[..., Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    other = Register(0x00, reset=0x20036468, access=Access.READ)
    monkeypatch.setattr(Debug, "REGISTERS", {**Debug.REGISTERS, "IDCODE": other})
    before = chip.flash
    chip.reset("power")
    with at_a_probe(chip, tmp_path) as (_, probe):
        told = message(flash(built(), probe))
    assert "found another chip at the probe, with the number 0x468; allowed: stm32g474" in told
    assert chip.flash == before


def test_an_image_of_another_board_is_refused(built: Callable[..., Path]) -> None:
    told = message(flash(built(board="zcu102"), "stlink"))
    assert "found an image for the board zcu102; allowed: stm32g474; nothing was changed" in told


def test_an_image_of_another_machine_is_refused(built: Callable[..., Path]) -> None:
    told = message(flash(built(machine="yoon_fixed_diagonal"), "stlink"))
    assert re.search(r"found an image of yoon_fixed_diagonal \w+; allowed: yoon2023 \w+", told)


def test_an_image_of_an_older_file_of_the_machine_is_refused(
    built: Callable[..., Path], tmp_path: Path
) -> None:
    text = Path(MACHINE).read_text()
    assert text.count('"20 N*m/s"') == 1
    newer = tmp_path / "yoon2023.toml"
    newer.write_text(text.replace('"20 N*m/s"', '"21 N*m/s"'))
    told = message(CliRunner().invoke(app, ["flash", str(newer), f"--image={built()}"]))
    assert re.search(r"found an image of yoon2023 (\w+); allowed: yoon2023 (?!\1)\w+", told)


def test_a_damaged_image_is_refused_and_told_by_info(
    built: Callable[..., Path], tmp_path: Path
) -> None:
    content = bytearray(built().read_bytes())
    content[len(content) // 2] ^= 4
    file = tmp_path / "damaged.elf"
    file.write_bytes(content)
    assert re.search(r"damaged: found \d+ bytes with the CRC \w+", message(flash(file, "stlink")))
    assert "damaged: found" in message(CliRunner().invoke(app, ["info", str(file)]))
    file.write_bytes(built().read_bytes()[:20_000])
    assert "found a part of an image" in message(CliRunner().invoke(app, ["info", str(file)]))


@pytest.mark.parametrize("suffix", [".elf", ".bin"])
def test_an_image_is_written_and_info_tells_what_it_is(
    suffix: str, built: Callable[..., Path], tmp_path: Path
) -> None:
    program = linked(built().parent)
    out = tmp_path / f"image{suffix}"
    made = image_command(program, out)
    assert made.exit_code == 0, made.output
    told = CliRunner().invoke(app, ["info", str(out)]).stdout
    record, content = read_image(out)
    assert len(content) == record.length
    for words in ("machine    yoon2023", "board      stm32g474", f"flags      {FLAGS}", "float"):
        assert words in told
    assert f"CRC        {record.crc:08x}" in told and f"length     {record.length} B" in told
    assert [path.name for path in tmp_path.iterdir()] == [out.name]


def test_a_program_that_was_only_linked_is_no_image_yet(built: Callable[..., Path]) -> None:
    told = message(flash(linked(built().parent), "stlink"))
    assert "found a program without length and CRC" in told and "turnbuckle image MACHINE" in told


def image_command(program: Path, out: Path) -> Result:
    """Make an image of a linked program."""
    return CliRunner().invoke(app, ["image", MACHINE, f"--program={program}", f"--out={out}"])


def test_a_program_without_a_record_makes_no_image(tmp_path: Path) -> None:
    out = tmp_path / "image.elf"
    for content in (Path(sys.executable).read_bytes(), b"", b"\x7fELF\x01\x01" + bytes(60)):
        program = tmp_path / "program"
        program.write_bytes(content)
        assert "found no program with a record" in message(image_command(program, out))
    assert not out.exists()


@pytest.mark.parametrize(
    ("limit", "words"),
    [
        ("size", r"flash: found \d{5} bytes of flash; allowed: 40000"),
        ("memory", r"memory: found \d+ bytes of memory; allowed: 512"),
        ("buses", r"bus: found 3 buses; allowed: 1"),
    ],
)
def test_a_machine_that_does_not_fit_is_refused_with_the_numbers(
    limit: str, words: str, built: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    most = {"size": 40_000, "memory": 512, "buses": 1}[limit]
    smaller: Any = {limit: most}
    monkeypatch.setitem(CHIPS, "stm32g474", replace(STM32G474, **smaller))
    program = linked(built().parent)
    assert re.search(words, message(image_command(program, Path("never.elf"))))
    assert re.search(words, message(flash(built(), "stlink")))


@pytest.mark.parametrize("probe", ["stlink", "cmsis-dap", "jlink"])
def test_a_probe_that_is_not_there_is_told(probe: str, built: Callable[..., Path]) -> None:
    told = message(flash(built(), probe))
    assert f"{probe}: found no such probe" in told and "lsusb" in told


def test_an_unknown_probe_is_refused(built: Callable[..., Path]) -> None:
    told = message(flash(built(), "jtagkey"))
    assert 'found "jtagkey"; allowed: stlink, cmsis-dap, jlink, or a file' in told


def test_a_probe_that_another_program_holds_is_told(
    chip: Chip, built: Callable[..., Path], tmp_path: Path
) -> None:
    """The words of libusb come from the file of the probe: there is no such probe here."""
    with at_a_probe(chip, tmp_path) as (_, probe):
        probe.write_text('error "Error: libusb_claim_interface() failed with LIBUSB_ERROR_BUSY"\n')
        told = message(flash(built(), probe))
    assert "held by another program" in told and "ps aux" in told


def test_a_probe_that_never_answers_is_given_up(
    chip: Chip, built: Callable[..., Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As where another OpenOCD is at the simulated probe, which takes one at a time."""
    monkeypatch.setattr(session, "PATIENCE", 1.0)
    with at_a_probe(chip, tmp_path) as (server, probe), socket.socket(socket.AF_UNIX) as other:
        other.connect(str(server.place))
        told = message(flash(built(), probe))
    assert "does not answer the probe: no answer within 1 s" in told and "not changed" in told


def test_without_openocd_its_package_is_named(
    built: Callable[..., Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = built()
    monkeypatch.setenv("PATH", str(tmp_path))
    assert "sudo apt-get install openocd" in message(flash(file, "stlink"))


@pytest.mark.parametrize("place", [0, 8, 600, -1])
def test_an_image_with_a_flipped_bit_stops_at_the_check_of_its_crc(
    place: int, built: Callable[..., Path]
) -> None:
    _, content = read_image(built())
    assert runs(Chip(content, faults="take"))
    damaged = bytearray(content)
    damaged[place] ^= 0x10
    assert not runs(Chip(bytes(damaged), faults="take"))

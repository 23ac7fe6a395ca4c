"""The commands `run` and `monitor`: what they take, what they print."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from turnbuckle.model.terminal import MachineFile, complete_machine

if TYPE_CHECKING:
    from turnbuckle.lab.live.telemetry import Request

Telemetry = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE",
        help="The program's shared file.  [default: /dev/shm/turnbuckle-<name>]",
        show_default=False,
    ),
]


def run(
    file: MachineFile,
    bus: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=ADAPTER:DEVICE",
            help="How a bus is reached, such as cable1=slcan:/dev/ttyACM0 or base=socketcan:can0."
            " Once for every bus.",
            show_default=False,
        ),
    ] = None,
    sim: Annotated[
        bool,
        typer.Option(
            "--sim",
            help="Run against simulated drives, in simulated time: on serial lines of their own,"
            " or, with --bus, on interfaces of the kernel, such as cable1=socketcan:vcan0.",
        ),
    ] = False,
    wire: Annotated[
        Literal["ordinary", "worst", "disturbed"],
        typer.Option(
            help="Simulated wires on which frames take their usual time, the longest that the bus"
            " proof allows, or are destroyed now and then."
        ),
    ] = "ordinary",
    arm: Annotated[
        bool, typer.Option("--arm", help="Arm as soon as every drive is configured.")
    ] = False,
    seconds: Annotated[
        float | None,
        typer.Option(
            metavar="S",
            help="Stop after S seconds of the machine's time.",
            show_default=False,
        ),
    ] = None,
    record: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="Keep the flight recorder in FILE; in a folder, in a file of the run's own.",
            show_default=False,
        ),
    ] = None,
    telemetry: Telemetry = None,
    program: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="A program compiled before; refused if it is another machine's."
            "  [default: compile one]",
            show_default=False,
        ),
    ] = None,
    precision: Annotated[
        Literal["double", "float"], typer.Option(help="Of the compiled program.")
    ] = "double",
    priority: Annotated[
        int | None,
        typer.Option(
            metavar="N",
            min=0,
            max=99,
            help="Real-time priority; 0 for none.  [default: 80]",
            show_default=False,
        ),
    ] = None,
    cpu: Annotated[
        int | None,
        typer.Option(metavar="N", min=0, help="Run on processor N alone.", show_default=False),
    ] = None,
) -> None:
    """Run a machine's program on its drives, or on simulated ones.

    Compiles the program and brings the machine up: drives identified and
    configured, then, armed, bases homed, cables measured and tightened. The
    states are told as they change; `turnbuckle monitor` shows more.

    Ctrl-C stops softly. Exit status: 0 stopped as asked, 1 stopped by a fault.
    After a fault the machine waits for a reset; with --sim, or with
    --seconds, the run ends.

    \b
    Example:
      turnbuckle run machines/yoon2023.toml --sim --arm --seconds 30
      turnbuckle run machines/yoon2023.toml --bus cable1=slcan:/dev/ttyACM0 \\
        --bus cable2=slcan:/dev/ttyACM1 --bus base=socketcan:can0
    """
    from turnbuckle.lab.live.run import Order, Voices, run_machine
    from turnbuckle.model.reading import load_machine

    refuse_contradictions(sim, wire, bus, seconds)
    machine = load_machine(file)
    further = [f"--cpu={cpu}"] if cpu is not None else []
    if priority is not None:
        further.append(f"--priority={priority}")
    order = Order(
        buses=bus or (),
        simulated=sim,
        wire=wire,
        arm=arm,
        seconds=seconds,
        record=record,
        telemetry=telemetry,
        program=program,
        precision=precision,
        further=further,
    )
    status = run_machine(machine, order, Voices(typer.echo, partial(typer.echo, err=True)))
    if status:
        raise typer.Exit(status)


def refuse_contradictions(
    sim: bool, wire: str, bus: list[str] | None, seconds: float | None
) -> None:
    """Options that do not go together."""
    if wire != "ordinary" and not sim:
        raise typer.BadParameter(f"--wire {wire} is for simulated drives: add --sim")
    if sim and not all("=socketcan:" in each for each in bus or ()):
        raise typer.BadParameter(
            "--bus is for real adapters, --sim for simulated drives; together they take interfaces"
            " of the kernel alone, such as --bus cable1=socketcan:vcan0"
        )
    if seconds is not None and not 0 < seconds < 1e9:
        raise typer.BadParameter("--seconds: a positive number of seconds is due")


def monitor(
    machine: Annotated[
        str,
        typer.Argument(
            metavar="FILE|NAME",
            help="The machine file, or the machine's name.",
            show_default=False,
            autocompletion=complete_machine,
        ),
    ],
    once: Annotated[bool, typer.Option("--once", help="Print one picture and end.")] = False,
    arm: Annotated[bool, typer.Option("--arm", help="Ask the program to arm.")] = False,
    stop: Annotated[bool, typer.Option("--stop", help="Ask for a soft stop.")] = False,
    reset: Annotated[
        bool, typer.Option("--reset", help="Ask it to leave the fault state.")
    ] = False,
    telemetry: Telemetry = None,
) -> None:
    """Watch a running machine, live in the terminal.

    Shows state, pose, tensions, drives, buses and timing. Waits for a
    program that does not run yet.

    With a machine file the program must be that machine's, and a planar
    machine is drawn. A request (--arm, --stop, --reset) is sent, and the
    command ends; in the living picture the keys a, s and r send them.

    \b
    Example:
      turnbuckle monitor machines/yoon2023.toml
      turnbuckle monitor yoon2023 --once
    """
    from rich.console import Console

    from turnbuckle.lab.live.monitor import print_once, request, subject_of, watch

    subject, console = subject_of(machine, telemetry), Console()
    wishes: dict[Request, bool] = {"arm": arm, "stop": stop, "reset": reset}
    asked = [name for name, wanted in wishes.items() if wanted]
    if not once and not asked:
        watch(subject.wait(console), subject.machine, console)
        return
    shared = subject.open()
    for name in asked:
        request(shared, name)
    if once:
        print_once(shared, subject.machine, console)

"""Which tests concern which file of the runtime, cheapest first."""

SUPERVISOR = (
    "tests/unit/test_directions.py",
    "tests/unit/test_supervisor_one_rail.py",
    "tests/unit/test_supervisor_without_rails.py",
    "tests/unit/test_supervisor.py",
    "tests/unit/test_supervisor_causes.py",
    "tests/unit/test_supervisor_limits.py",
)
MESSAGES = ("tests/unit/test_canopen_messages.py",)
NETWORK = (
    "tests/wire/test_network.py",
    "tests/wire/test_drive_setup.py",
    "tests/wire/test_master.py",
    "tests/wire/test_drive_homing.py",
)
#: The whole machine in lockstep, from power-on to RUN and through its stops.
JOURNEY = (
    "tests/closed_loop/test_bring_up.py",
    "tests/closed_loop/test_limits_on_the_plant.py",
)
OWN = {
    "core/calibration.c": ("tests/equivalence/test_calibration.py",),
    "core/pose_space.c": (
        "tests/equivalence/test_calibration.py",
        "tests/equivalence/test_watch.py",
    ),
    "core/watch.c": ("tests/equivalence/test_watch.py",),
    "core/carriage.c": ("tests/unit/test_carriage.py",),
    "core/controller.c": (
        "tests/unit/test_controller_step.py",
        "tests/unit/test_controller_reference.py",
        "tests/closed_loop/test_closed_loop.py",
    ),
    "core/torque_gate.c": ("tests/unit/test_torque_gate.py",),
    "core/guide.c": ("tests/unit/test_guide.py",),
    "core/measurement.c": ("tests/unit/test_measurement.py",),
    "core/recorder.c": ("tests/unit/test_flight.py",),
    "core/words.c": ("tests/unit/test_supervisor_words.py",),
    "canopen/cia402.c": ("tests/unit/test_cia402.py",),
    "canopen/drive_kind.c": ("tests/unit/test_emcy.py", "tests/wire/test_sdo.py"),
    "canopen/emcy.c": ("tests/unit/test_emcy.py",),
    "canopen/sdo.c": ("tests/wire/test_sdo.py",),
    "canopen/setup.c": ("tests/wire/test_drive_setup.py",),
}


def suite_of(file: str) -> tuple[str, ...]:
    """The tests that a mutant of a file in runtime/ has to pass to survive."""
    of_folder = SUPERVISOR if file.startswith("core/") else (*MESSAGES, *NETWORK)
    return tuple(dict.fromkeys((*OWN.get(file, ()), *of_folder, *JOURNEY)))


def every_test() -> tuple[str, ...]:
    """All of them, the journey last."""
    of_parts = [test for tests in OWN.values() for test in tests]
    return tuple(dict.fromkeys((*of_parts, *MESSAGES, *NETWORK, *SUPERVISOR, *JOURNEY)))

"""The EPOS4 of maxon (vendor 0xFB), after its firmware specification."""

from turnbuckle.model.bus.drive_kinds.entry import Entry, array
from turnbuckle.model.bus.drive_kinds.kind import (
    TURN_A_MINUTE,
    DriveError,
    DriveKind,
    HomingObjects,
    MotorObjects,
    Option,
    Place,
    Severity,
    Simulated,
    error,
    fixed,
    per_mille_of_rated_torque,
)

MILLI, MICRO = fixed(1e-3), fixed(1e-6)
COUNT, PULSE = fixed(1.0), fixed(4.0)

RATED_TORQUE = Place(0x6076, 0, 4, "rated torque of the motor", MICRO, "N m", lowest=1)
MOTOR = MotorObjects(
    current_limit=Place(0x3001, 2, 4, "current limit", MILLI, "A"),
    rated_torque=RATED_TORQUE,
    nominal_current=Place(0x3001, 1, 4, "nominal current of the motor", MILLI, "A"),
    torque_constant=Place(0x3001, 5, 4, "torque constant of the motor", MICRO, "N m/A"),
    encoder=Place(0x3010, 1, 4, "pulses of the encoder", PULSE, "counts", whole=True),
)

HOMING = HomingObjects(
    forward=-3,
    backward=-4,
    here=37,
    threshold=Place(0x30B2, 0, 2, "current that tells the stop", MILLI, "A"),
    speed=Place(0x6099, 1, 4, "homing speed, towards the stop", TURN_A_MINUTE, "rad/s", lowest=1),
    search=Place(
        0x6099, 2, 4, "homing speed, of the second search", TURN_A_MINUTE, "rad/s", lowest=1
    ),
    acceleration=Place(0x609A, 0, 4, "homing acceleration", TURN_A_MINUTE, "rad/s^2", lowest=1),
    offset=Place(0x30B1, 0, 4, "distance off the stop", COUNT, "counts", signed=True),
    home=Place(0x30B0, 0, 4, "position at the stop", COUNT, "counts", signed=True),
)

COMMUNICATION = Severity.COMMUNICATION
ERRORS = (
    DriveError(0x1080, 0x1088, "generic initialisation error"),
    error(0x1090, "firmware and hardware do not fit"),
    error(0x2320, "power stage protection"),
    error(0x4380, "motor too hot"),
    error(0x5113, "logic supply voltage too low"),
    DriveError(0x5280, 0x5282, "hardware defect"),
    DriveError(0x5480, 0x5483, "hardware defect"),
    error(0x6080, "sign of life error"),
    error(0x6081, "extension watchdog"),
    DriveError(0x6180, 0x61F0, "internal software error"),
    error(0x6320, "software parameter error"),
    error(0x6380, "stored parameters corrupt"),
    DriveError(0x7380, 0x7382, "position sensor breach or hall sensor error; homing is lost"),
    DriveError(0x7388, 0x738A, "encoder or hall sensor error; homing is lost"),
    DriveError(0x738C, 0x738D, "SSI sensor error"),
    DriveError(0x7390, 0x7391, "sensor missing"),
    error(0x7392, "sensor error; homing is lost"),
    DriveError(0x8110, 0x8111, "CAN overrun: messages lost", COMMUNICATION),
    DriveError(0x8180, 0x8184, "EtherCAT communication error", COMMUNICATION),
    error(0x81FD, "CAN bus-off", COMMUNICATION),
    DriveError(0x81FE, 0x81FF, "CAN queue overflow", COMMUNICATION),
    DriveError(0x8280, 0x8281, "EtherCAT process data error"),
    DriveError(0x8A80, 0x8A81, "limit switch"),
    error(0x8A82, "software position limit"),
    error(0x8A88, "safe torque off: is the emergency stop pressed?"),
    error(0xFF01, "overloaded (warning)", Severity.WARNING),
    error(0xFF02, "watchdog; homing is lost"),
    error(0xFF0B, "peak overload"),
    error(0xFF10, "controller gain error"),
    DriveError(0xFF11, 0xFF24, "auto tuning error"),
)
ABORTS = {
    0x06010003: "subindex 0 must be 0 before the other entries are written",
    0x06010004: "complete access not supported",
    0x0F00FFBE: "password wrong",
    0x0F00FFBF: "command not legal",
    0x0F00FFC0: "not allowed in this NMT state",
}

#: Types, access, defaults as the drive has them; the ranges are those of one variant.
OBJECTS = (
    Entry(0x2000, 0, "node-ID", "B", "rw", 1, lowest=1, highest=127),
    Entry(0x2001, 0, "CAN bit rate", "B", "rw", 0, highest=9),
    *array(0x2200, "power supply voltage [0.1 V]", "H", "ro", [240]),
    *array(0x3000, "axis configuration", "I", "rw", [1, 0x00000101, 1]),
    Entry(0x3001, 0, "number of entries", "B", "const", 5),
    Entry(0x3001, 1, "nominal current [mA]", "I", "rw", highest=50_000, power_off=True),
    Entry(0x3001, 2, "output current limit [mA]", "I", "rw", highest=150_000, power_off=True),
    Entry(0x3001, 3, "pole pairs", "B", "rw", 1, lowest=1, highest=255, power_off=True),
    Entry(0x3001, 4, "thermal time constant [0.1 s]", "H", "rw", 40, lowest=1, power_off=True),
    Entry(0x3001, 5, "torque constant [uN m/A]", "I", "rw", highest=10**7, power_off=True),
    *array(0x3002, "electrical data", "I", "rw", [500, 100]),
    Entry(0x3010, 0, "number of entries", "B", "const", 1),
    Entry(
        0x3010, 1, "encoder pulses/turn", "I", "rw", 1024, lowest=16, highest=10**6, power_off=True
    ),
    Entry(0x30B0, 0, "home position", "i", "rw", taken=True),
    Entry(0x30B1, 0, "home offset move distance", "i", "rw"),
    Entry(0x30B2, 0, "current threshold for homing [mA]", "H", "rw", 500, taken=True),
    Entry(0x30D1, 0, "number of entries", "B", "const", 2),
    Entry(0x30D1, 1, "current averaged [mA]", "i", "ro", sent=True, signal="current"),
    Entry(0x30D1, 2, "current [mA]", "i", "ro", sent=True, signal="current"),
    *array(0x3200, "I2t level [%]", "H", "ro", [0, 0], sent=True),
    *array(0x3201, "temperature power stage [0.1 degC]", "h", "ro", [350]),
    *array(0x3202, "STO input states", "B", "ro", [3]),
    Entry(0x6007, 0, "abort connection option code", "h", "rw", 3, lowest=0, highest=3),
    Entry(0x6076, 0, "motor rated torque [uN m]", "I", "ro"),
    *array(0x6099, "homing speed [rpm]", "I", "rw", [100, 10], lowest=1),
    Entry(0x609A, 0, "homing acceleration [rpm/s]", "I", "rw", 1000, lowest=1),
)
SIMULATED = Simulated(
    product=0x61500000,
    revision=0x01700000,
    objects=OBJECTS,
    fault_option=frozenset({0x6320, 0x8611, 0x8A80, 0x8A81, 0x8A82, 0xFF10}),
    abort_option=frozenset(
        {0x6081, 0x8110, 0x8111, 0x8120, 0x8130, 0x8150, 0x81FD, 0x81FE, 0x81FF, 0x8210, 0x8250}
    ),
    latched=frozenset({0x8120, 0x8130}),
    homing_lost=frozenset({0x7380, 0x7381, 0x7382, 0x7388, 0x7389, 0x738A, 0x7392, 0xFF02}),
    wrong_state=0x0F00FFC0,
    map_in_use=0x06010003,
)

KIND = DriveKind(
    name="epos4",
    meaning="maxon EPOS4",
    vendor=0xFB,
    motor=MOTOR,
    torque=per_mille_of_rated_torque(RATED_TORQUE),
    torque_unit="per mille of the rated torque",
    modes={"torque": 10, "position": 8, "homing": 6},
    connection_loss=Option(0x6007, 0, 2, "without the master", {"disable": 2, "quick_stop": 3}),
    quick_stop=Option(0x605A, 0, 2, "quick stop", {"off": 2, "hold": 6}),
    homing=HOMING,
    errors=ERRORS,
    aborts=ABORTS,
    simulated=SIMULATED,
)

/* Why the machine stops: every cause once, with whom it blames, how the machine stops, what is wrong
 * (to be read after the culprit's name) and what the user can do. docs/safety.md says the same, and how
 * each is found. */
#ifndef TB_CAUSES_H
#define TB_CAUSES_H

/** ROW(name, culprit, reaction, words, advice) of every cause, in the order of their numbers. */
#define TB_CAUSES(ROW) \
    ROW(NONE, NOBODY, SOFT, "", "") \
    ROW(REQUESTED, NOBODY, SOFT, "a stop was asked for", "") \
    ROW(DRIVE_MISSING, DRIVE, SOFT, "did not boot, or does not answer", \
        "check power, cable, terminators, node number and bit rate") \
    ROW(DRIVE_DIFFERENT, DRIVE, SOFT, "is not the drive of the machine file", \
        "correct the machine file, or change the drive") \
    ROW(DRIVE_SETUP, DRIVE, SOFT, "did not take its configuration", \
        "correct the machine file, or reset the drive's parameters") \
    ROW(DRIVE_TWICE, DRIVE, SOFT, "two nodes have its number", "give one of them another number") \
    ROW(STRANGER, BUS, SOFT, "a message that the machine file does not have", \
        "take it off the bus, or put it with its frames into a table [[node]]") \
    ROW(DRIVE_SILENT, DRIVE, HARD, "stopped answering", \
        "check its power and its cable; it may have restarted") \
    ROW(DRIVE_LATE, DRIVE, SOFT, "answers too late again and again", \
        "check the bus load and the adapter") \
    ROW(DRIVE_FAULT, DRIVE, HARD, "is in its fault state", \
        "clear what its manual names, then reset") \
    ROW(DRIVE_STATE, DRIVE, HARD, "left its power state or mode", \
        "check safe torque off and the supply") \
    ROW(DRIVE_STUCK, DRIVE, SOFT, "did not reach its power state or mode in time", \
        "check safe torque off and the supply") \
    ROW(DRIVE_DEAF, DRIVE, HARD, "does not give the torque it is told", \
        "check its CAN error counters, its motor's cable, its current limit") \
    ROW(BUS_OFF, BUS, HARD, "off, or its device has gone", \
        "check cable, terminators, bit rate and adapter") \
    ROW(BUS_FULL, BUS, SOFT, "a frame could not be sent", \
        "check that the drives have power; look at the bus load") \
    ROW(BUS_CORRUPT, BUS, SOFT, "delivers malformed lines or frames", \
        "check its adapter and bit rate, look for another program on it") \
    ROW(CYCLES_MISSED, NOBODY, SOFT, "the control loop came too late", \
        "give it real-time priority, and the computer less to do") \
    ROW(HOMING, DRIVE, SOFT, "homing failed, or found no stop in time", \
        "check threshold current, direction, and what blocks the carriage") \
    ROW(CALIBRATION, NOBODY, SOFT, "the cables' zeros could not be found", \
        "hold the handle loosely, do not follow the bases; if none moves, move it around") \
    ROW(ENCODER_JUMP, DRIVE, HARD, "its position jumped", "check the encoder and its cable") \
    ROW(CABLE_SLACK, CABLE, SOFT, "is slack", \
        "see that it is hooked in, on its pulley, and wound well") \
    ROW(CABLE_BREAK, CABLE, HARD, "is broken, or has come off", "replace it") \
    ROW(RUNAWAY, CABLE, HARD, "is faster than it may be", \
        "look for a broken cable, and hold the handle") \
    ROW(CLOSURE, NOBODY, SOFT, "the measured lengths disagree", \
        "calibrate again; compare pulleys, rails and anchors with the machine file") \
    ROW(BASE_LOST, DRIVE, SOFT, "its base does not follow", "look what blocks the carriage") \
    ROW(CONTROLLER, NOBODY, SOFT, "the controller step failed too often", \
        "look for a force that is no number") \
    ROW(MEMORY, NOBODY, HARD, "the runtime's memory was damaged", \
        "report it: computer or program are at fault") \
    ROW(BASE_RUNAWAY, DRIVE, HARD, "its carriage is faster than it may be", \
        "check its encoder and its belt") \
    ROW(BASE_BLOCKED, DRIVE, HARD, "its carriage does not move, however hard it is pushed", \
        "look what blocks the carriage, then check its encoder and its belt") \
    ROW(WRONG_WAY, DRIVE, HARD, "its position goes against its torque", \
        "check the wiring of encoder and motor, and `direction` in the machine file") \
    ROW(ANSWERS_INCOMPLETE, DRIVE, SOFT, "has never answered when all the others have", \
        "check the bus load, its cable and the adapter") \
    ROW(DRIVE_LOCAL, DRIVE, HARD, "is not under remote control", \
        "close the drive's own software, see that the bus controls it") \
    ROW(OTHER_MASTER, BUS, SOFT, "another master is on the bus", \
        "end the other program, or take the other master off the bus")

#endif

#include "words.h"

#include <stddef.h>

static const char *const states[] = {
    [TB_STATE_INIT] = "waiting for every drive to boot",
    [TB_STATE_IDENTIFY] = "comparing the drives with the machine file",
    [TB_STATE_CONFIGURE] = "configuring the drives",
    [TB_STATE_HOME] = "homing bases, finding the cables' zeros",
    [TB_STATE_TENSION] = "tensioning the cables",
    [TB_STATE_RUN] = "running",
    [TB_STATE_SOFT_STOP] = "stopping",
    [TB_STATE_HARD_STOP] = "stopping at once",
    [TB_STATE_FAULT] = "stopped by a fault",
};

static const char *const phases[] = {
    [TB_PHASE_NONE] = "",
    [TB_PHASE_CONTRACT] = "writing the drives' configuration",
    [TB_PHASE_START] = "starting the drives",
    [TB_PHASE_FAULT_RESET] = "resetting the drives' faults",
    [TB_PHASE_READY] = "ready to arm",
    [TB_PHASE_CABLE_MODE] = "cable drives to torque mode",
    [TB_PHASE_CABLE_POWER] = "powering the cable drives",
    [TB_PHASE_TIGHTEN] = "winding in slack",
    [TB_PHASE_TRY_CABLES] = "trying which way the cables' encoders count",
    [TB_PHASE_TRY_MODE] = "base drives to torque mode",
    [TB_PHASE_TRY_POWER] = "powering the base drives for the trial",
    [TB_PHASE_TRY_BASES] = "trying which way the bases' encoders count",
    [TB_PHASE_TRY_RELEASE] = "base drives off after the trial",
    [TB_PHASE_BASE_MODE] = "base drives to homing mode",
    [TB_PHASE_BASE_POWER] = "powering the base drives",
    [TB_PHASE_BASE_HOMING] = "bases run to their stops",
    [TB_PHASE_BASE_RELEASE] = "base drives off",
    [TB_PHASE_BASE_WORK_MODE] = "base drives to their working mode",
    [TB_PHASE_BASE_WORK_POWER] = "powering the base drives again",
    [TB_PHASE_GATHER] = "bases to where their sweep begins",
    [TB_PHASE_SWEEP] = "measuring poses: where no base moves, move the handle around",
    [TB_PHASE_SOLVE] = "computing the cables' zeros",
    [TB_PHASE_APPROACH] = "bases to the handle",
    [TB_PHASE_CLOSE] = "checking that the lengths agree",
    [TB_PHASE_RELAX] = "cables to minimum tension",
    [TB_PHASE_SLACKEN] = "cables to no torque",
    [TB_PHASE_POWER_OFF] = "switching the drives off",
};

static const char *const causes[] = {
    [TB_CAUSE_NONE] = "",
    [TB_CAUSE_REQUESTED] = "a stop was asked for",
    [TB_CAUSE_DRIVE_MISSING] = "did not boot, or does not answer",
    [TB_CAUSE_DRIVE_DIFFERENT] = "is not the drive of the machine file",
    [TB_CAUSE_DRIVE_SETUP] = "did not take its configuration",
    [TB_CAUSE_DRIVE_TWICE] = "two nodes have its number",
    [TB_CAUSE_STRANGER] = "a message that the machine file does not have",
    [TB_CAUSE_DRIVE_SILENT] = "stopped answering",
    [TB_CAUSE_DRIVE_LATE] = "answers too late again and again",
    [TB_CAUSE_DRIVE_FAULT] = "is in its fault state",
    [TB_CAUSE_DRIVE_STATE] = "left its power state or mode",
    [TB_CAUSE_DRIVE_STUCK] = "did not reach its power state or mode in time",
    [TB_CAUSE_DRIVE_DEAF] = "does not give the torque it is told",
    [TB_CAUSE_BUS_OFF] = "off, or its device has gone",
    [TB_CAUSE_BUS_FULL] = "a frame could not be sent",
    [TB_CAUSE_BUS_CORRUPT] = "delivers malformed lines or frames",
    [TB_CAUSE_CYCLES_MISSED] = "the control loop came too late",
    [TB_CAUSE_HOMING] = "homing failed, or found no stop in time",
    [TB_CAUSE_CALIBRATION] = "the cables' zeros could not be found",
    [TB_CAUSE_ENCODER_JUMP] = "its position jumped",
    [TB_CAUSE_CABLE_SLACK] = "is slack",
    [TB_CAUSE_CABLE_BREAK] = "is broken, or has come off",
    [TB_CAUSE_RUNAWAY] = "is faster than it may be",
    [TB_CAUSE_CLOSURE] = "the measured lengths disagree",
    [TB_CAUSE_BASE_LOST] = "its base does not follow",
    [TB_CAUSE_CONTROLLER] = "the controller step failed too often",
    [TB_CAUSE_MEMORY] = "the runtime's memory was damaged",
    [TB_CAUSE_BASE_RUNAWAY] = "its carriage is faster than it may be",
    [TB_CAUSE_BASE_BLOCKED] = "its carriage does not move, however hard it is pushed",
    [TB_CAUSE_WRONG_WAY] = "its position goes against its torque",
    [TB_CAUSE_ANSWERS_INCOMPLETE] = "has never answered when all the others have",
    [TB_CAUSE_DRIVE_LOCAL] = "is not under remote control",
    [TB_CAUSE_OTHER_MASTER] = "another master is on the bus",
};

static const char *const culprits[] = {
    [TB_CAUSE_NONE] = "",
    [TB_CAUSE_REQUESTED] = "",
    [TB_CAUSE_DRIVE_MISSING] = "drive",
    [TB_CAUSE_DRIVE_DIFFERENT] = "drive",
    [TB_CAUSE_DRIVE_SETUP] = "drive",
    [TB_CAUSE_DRIVE_TWICE] = "drive",
    [TB_CAUSE_STRANGER] = "bus",
    [TB_CAUSE_DRIVE_SILENT] = "drive",
    [TB_CAUSE_DRIVE_LATE] = "drive",
    [TB_CAUSE_DRIVE_FAULT] = "drive",
    [TB_CAUSE_DRIVE_STATE] = "drive",
    [TB_CAUSE_DRIVE_STUCK] = "drive",
    [TB_CAUSE_DRIVE_DEAF] = "drive",
    [TB_CAUSE_BUS_OFF] = "bus",
    [TB_CAUSE_BUS_FULL] = "bus",
    [TB_CAUSE_BUS_CORRUPT] = "bus",
    [TB_CAUSE_CYCLES_MISSED] = "",
    [TB_CAUSE_HOMING] = "drive",
    [TB_CAUSE_CALIBRATION] = "",
    [TB_CAUSE_ENCODER_JUMP] = "drive",
    [TB_CAUSE_CABLE_SLACK] = "cable",
    [TB_CAUSE_CABLE_BREAK] = "cable",
    [TB_CAUSE_RUNAWAY] = "cable",
    [TB_CAUSE_CLOSURE] = "",
    [TB_CAUSE_BASE_LOST] = "drive",
    [TB_CAUSE_CONTROLLER] = "",
    [TB_CAUSE_MEMORY] = "",
    [TB_CAUSE_BASE_RUNAWAY] = "drive",
    [TB_CAUSE_BASE_BLOCKED] = "drive",
    [TB_CAUSE_WRONG_WAY] = "drive",
    [TB_CAUSE_ANSWERS_INCOMPLETE] = "drive",
    [TB_CAUSE_DRIVE_LOCAL] = "drive",
    [TB_CAUSE_OTHER_MASTER] = "bus",
};

static const char *const advice[] = {
    [TB_CAUSE_NONE] = "",
    [TB_CAUSE_REQUESTED] = "",
    [TB_CAUSE_DRIVE_MISSING] = "check power, cable, terminators, node number and bit rate",
    [TB_CAUSE_DRIVE_DIFFERENT] = "correct the machine file, or change the drive",
    [TB_CAUSE_DRIVE_SETUP] = "correct the machine file, or reset the drive's parameters",
    [TB_CAUSE_DRIVE_TWICE] = "give one of them another number",
    [TB_CAUSE_STRANGER] = "take it off the bus, or put it with its frames into a table [[node]]",
    [TB_CAUSE_DRIVE_SILENT] = "check its power and its cable",
    [TB_CAUSE_DRIVE_LATE] = "check the bus load and the adapter",
    [TB_CAUSE_DRIVE_FAULT] = "clear what its manual names, then reset",
    [TB_CAUSE_DRIVE_STATE] = "check safe torque off and the supply",
    [TB_CAUSE_DRIVE_STUCK] = "check safe torque off and the supply",
    [TB_CAUSE_DRIVE_DEAF] = "check its CAN error counters, its motor's cable, its current limit",
    [TB_CAUSE_BUS_OFF] = "check cable, terminators, bit rate and adapter",
    [TB_CAUSE_BUS_FULL] = "check that the drives have power",
    [TB_CAUSE_BUS_CORRUPT] = "check its adapter and bit rate, look for another program on it",
    [TB_CAUSE_CYCLES_MISSED] = "give it real-time priority, and the computer less to do",
    [TB_CAUSE_HOMING] = "check threshold current, direction, and what blocks the carriage",
    [TB_CAUSE_CALIBRATION] =
        "hold the handle loosely, do not follow the bases; if none moves, move it around",
    [TB_CAUSE_ENCODER_JUMP] = "check the encoder and its cable",
    [TB_CAUSE_CABLE_SLACK] = "see that it is hooked in, on its pulley, and wound well",
    [TB_CAUSE_CABLE_BREAK] = "replace it",
    [TB_CAUSE_RUNAWAY] = "look for a broken cable",
    [TB_CAUSE_CLOSURE] = "compare pulleys, rails and anchors with the machine file",
    [TB_CAUSE_BASE_LOST] = "look what blocks the carriage",
    [TB_CAUSE_CONTROLLER] = "look for a force that is no number",
    [TB_CAUSE_MEMORY] = "report it: computer or program are at fault",
    [TB_CAUSE_BASE_RUNAWAY] = "check its encoder and its belt",
    [TB_CAUSE_BASE_BLOCKED] = "look what blocks the carriage, then check its encoder and its belt",
    [TB_CAUSE_WRONG_WAY] =
        "check the wiring of encoder and motor, and `direction` in the machine file",
    [TB_CAUSE_ANSWERS_INCOMPLETE] = "check the bus load, its cable and the adapter",
    [TB_CAUSE_DRIVE_LOCAL] = "close the drive's own software, see that the bus controls it",
    [TB_CAUSE_OTHER_MASTER] = "end the other program, or take the other master off the bus",
};

#define COUNT(texts) (sizeof(texts) / sizeof((texts)[0]))

static const char *text(const char *const texts[], size_t count, size_t number)
{
    return (number < count) ? texts[number] : "unknown";
}

const char *tb_state_text(tb_state state)
{
    return text(states, COUNT(states), (size_t)state);
}

const char *tb_phase_text(tb_phase phase)
{
    return text(phases, COUNT(phases), (size_t)phase);
}

const char *tb_cause_text(tb_cause cause)
{
    return text(causes, COUNT(causes), (size_t)cause);
}

const char *tb_culprit_text(tb_cause cause)
{
    return text(culprits, COUNT(culprits), (size_t)cause);
}

const char *tb_advice_text(tb_cause cause)
{
    return text(advice, COUNT(advice), (size_t)cause);
}

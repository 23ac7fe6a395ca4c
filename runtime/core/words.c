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

#define WORDS(name, culprit, reaction, words, advice) [TB_CAUSE_##name] = words,
#define CULPRIT(name, culprit, reaction, words, advice) [TB_CAUSE_##name] = culprit,
#define ADVICE(name, culprit, reaction, words, advice) [TB_CAUSE_##name] = advice,

#define NOBODY ""
#define DRIVE "drive"
#define CABLE "cable"
#define BUS "bus"

static const char *const causes[] = {TB_CAUSES(WORDS)};
static const char *const culprits[] = {TB_CAUSES(CULPRIT)};
static const char *const advice[] = {TB_CAUSES(ADVICE)};

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

#include "cia402.h"

#include <stddef.h>

/* Bits 0 to 3, 5 and 6 tell the state; voltage (4), warning (7) and the rest do not. */
typedef struct {
    uint16_t mask;
    uint16_t value;
    tb_power power;
} tb_status_pattern;

static const tb_status_pattern patterns[] = {
    {0x4F, 0x00, TB_POWER_NOT_READY},      {0x4F, 0x40, TB_POWER_OFF},
    {0x6F, 0x21, TB_POWER_READY},          {0x6F, 0x23, TB_POWER_ON},
    {0x6F, 0x27, TB_POWER_ENABLED},        {0x6F, 0x07, TB_POWER_QUICK_STOP},
    {0x4F, 0x0F, TB_POWER_FAULT_REACTION}, {0x4F, 0x08, TB_POWER_FAULT}};

/* Commands of the controlword */
#define DISABLE_VOLTAGE 0x0000u
#define QUICK_STOP 0x0002u
#define SHUTDOWN 0x0006u
#define SWITCH_ON 0x0007u /* from above: disable operation */
#define ENABLE 0x000Fu

#define POWERS 9

/* Towards READY and ENABLED a drive that stopped by itself goes through OFF: nothing but a new way
 * up puts torque on it again. */
static const uint16_t towards_ready[POWERS] = {
    [TB_POWER_OFF] = SHUTDOWN,
    [TB_POWER_READY] = SWITCH_ON,
    [TB_POWER_ON] = SWITCH_ON,
    [TB_POWER_ENABLED] = SWITCH_ON,
};

static const uint16_t towards_enabled[POWERS] = {
    [TB_POWER_OFF] = SHUTDOWN,
    [TB_POWER_READY] = SWITCH_ON,
    [TB_POWER_ON] = ENABLE,
    [TB_POWER_ENABLED] = ENABLE,
};

/* Bits 13 (error), 12 (attained) and 10 (target reached) of the statusword, as a number */
static const tb_homing homings[8] = {
    TB_HOMING_RUNNING, TB_HOMING_IDLE,   TB_HOMING_RUNNING, TB_HOMING_DONE,
    TB_HOMING_FAILED,  TB_HOMING_FAILED, TB_HOMING_FAILED,  TB_HOMING_FAILED,
};

tb_power tb_cia402_power(uint16_t statusword)
{
    for (size_t i = 0; i < (sizeof patterns / sizeof patterns[0]); i++) {
        if ((statusword & patterns[i].mask) == patterns[i].value) {
            return patterns[i].power;
        }
    }
    return TB_POWER_UNKNOWN;
}

tb_homing tb_cia402_homing(uint16_t statusword)
{
    return homings[((statusword >> 11) & 6u) | ((statusword >> 10) & 1u)];
}

static uint16_t reset_fault(tb_power power, uint16_t previous)
{
    bool const is_low = (previous & TB_CONTROL_FAULT_RESET) == 0;
    return ((power == TB_POWER_FAULT) && is_low) ? TB_CONTROL_FAULT_RESET : DISABLE_VOLTAGE;
}

static uint16_t enable(tb_power power, bool home)
{
    bool const homes = home && (power == TB_POWER_ENABLED);
    return (uint16_t)(towards_enabled[power] | (homes ? TB_CONTROL_HOMING_START : 0u));
}

uint16_t tb_cia402_controlword(tb_power power, tb_goal goal, bool home, uint16_t previous)
{
    switch (goal) {
    case TB_GOAL_READY:
        return towards_ready[power];
    case TB_GOAL_ENABLED:
        return enable(power, home);
    case TB_GOAL_QUICK_STOP:
        return QUICK_STOP;
    case TB_GOAL_FAULT_RESET:
        return reset_fault(power, previous);
    case TB_GOAL_OFF:
    default:
        return DISABLE_VOLTAGE;
    }
}

/* Rows of a description (layout.h): what a cycle sees and orders, and the enumerations in it. The rows
 * of TB_CONTROLLER_LAYOUT stand before these. */
#ifndef TB_CYCLE_LAYOUT_H
#define TB_CYCLE_LAYOUT_H

#include "cause.h"
#include "controller_layout.h"
#include "cycle.h"

#define TB_CYCLE_LAYOUT                                                                            \
    TB_LAYOUT_STRUCT(drive_report)                                                                 \
    TB_LAYOUT_NUMBER(drive_report, position)                                                       \
    TB_LAYOUT_NUMBER(drive_report, torque)                                                         \
    TB_LAYOUT_NUMBER(drive_report, statusword)                                                     \
    TB_LAYOUT_NUMBER(drive_report, error_code)                                                     \
    TB_LAYOUT_NUMBER(drive_report, error_class)                                                    \
    TB_LAYOUT_NUMBER(drive_report, power)                                                          \
    TB_LAYOUT_NUMBER(drive_report, mode)                                                           \
    TB_LAYOUT_NUMBER(drive_report, homing)                                                         \
    TB_LAYOUT_NUMBER(drive_report, fresh)                                                          \
    TB_LAYOUT_NUMBER(drive_report, age)                                                            \
    TB_LAYOUT_NUMBER(drive_report, missed)                                                         \
    TB_LAYOUT_NUMBER(drive_report, late)                                                           \
    TB_LAYOUT_NUMBER(drive_report, silent)                                                         \
    TB_LAYOUT_NUMBER(drive_report, task)                                                           \
    TB_LAYOUT_NUMBER(drive_report, progress)                                                       \
    TB_LAYOUT_NUMBER(drive_report, failure)                                                        \
    TB_LAYOUT_NUMBER(drive_report, subindex)                                                       \
    TB_LAYOUT_NUMBER(drive_report, index)                                                          \
    TB_LAYOUT_NUMBER(drive_report, detail)                                                         \
    TB_LAYOUT_STRUCT(bus_report)                                                                   \
    TB_LAYOUT_NUMBER(bus_report, state)                                                            \
    TB_LAYOUT_NUMBER(bus_report, refused)                                                          \
    TB_LAYOUT_NUMBER(bus_report, stranger)                                                         \
    TB_LAYOUT_NUMBER(bus_report, malformed)                                                        \
    TB_LAYOUT_STRUCT(drive_order)                                                                  \
    TB_LAYOUT_NUMBER(drive_order, torque)                                                          \
    TB_LAYOUT_NUMBER(drive_order, position)                                                        \
    TB_LAYOUT_NUMBER(drive_order, goal)                                                            \
    TB_LAYOUT_NUMBER(drive_order, mode)                                                            \
    TB_LAYOUT_NUMBER(drive_order, task)                                                            \
    TB_LAYOUT_NUMBER(drive_order, home)                                                            \
    TB_LAYOUT_STRUCT(observation)                                                                  \
    TB_LAYOUT_PARTS(observation, drives, drive_report)                                             \
    TB_LAYOUT_PARTS(observation, buses, bus_report)                                                \
    TB_LAYOUT_NUMBERS(observation, force)                                                          \
    TB_LAYOUT_NUMBERS(observation, hand_force)                                                     \
    TB_LAYOUT_NUMBER(observation, hand_force_fresh)                                                \
    TB_LAYOUT_NUMBER(observation, requests)                                                        \
    TB_LAYOUT_NUMBER(observation, missed)                                                          \
    TB_LAYOUT_STRUCT(orders)                                                                       \
    TB_LAYOUT_PARTS(orders, drives, drive_order)                                                   \
    TB_LAYOUT_PART(orders, controller, outputs)                                                    \
    TB_LAYOUT_NUMBERS(orders, slack)                                                               \
    TB_LAYOUT_NUMBER(orders, beat)                                                                 \
    TB_LAYOUT_NUMBER(orders, state)                                                                \
    TB_LAYOUT_NUMBER(orders, phase)                                                                \
    TB_LAYOUT_NUMBER(orders, cause)                                                                \
    TB_LAYOUT_NUMBER(orders, culprit)                                                              \
    TB_LAYOUT_NUMBER(orders, index)                                                                \
    TB_LAYOUT_NUMBER(orders, subindex)                                                             \
    TB_LAYOUT_NUMBER(orders, failure)                                                              \
    TB_LAYOUT_NUMBER(orders, detail)

#define TB_LAYOUT_CAUSE(name, culprit, reaction, words, advice) TB_LAYOUT_VALUE(CAUSE_##name)

/** The enumerations of the core. */
#define TB_ENUMERATIONS_LAYOUT                                                                     \
    TB_LAYOUT_ENUMERATION(state)                                                                   \
    TB_LAYOUT_VALUE(STATE_INIT)                                                                    \
    TB_LAYOUT_VALUE(STATE_IDENTIFY)                                                                \
    TB_LAYOUT_VALUE(STATE_CONFIGURE)                                                               \
    TB_LAYOUT_VALUE(STATE_HOME)                                                                    \
    TB_LAYOUT_VALUE(STATE_TENSION)                                                                 \
    TB_LAYOUT_VALUE(STATE_RUN)                                                                     \
    TB_LAYOUT_VALUE(STATE_SOFT_STOP)                                                               \
    TB_LAYOUT_VALUE(STATE_HARD_STOP)                                                               \
    TB_LAYOUT_VALUE(STATE_FAULT)                                                                   \
    TB_LAYOUT_ENUMERATION(phase)                                                                   \
    TB_LAYOUT_VALUE(PHASE_NONE)                                                                    \
    TB_LAYOUT_VALUE(PHASE_CONTRACT)                                                                \
    TB_LAYOUT_VALUE(PHASE_START)                                                                   \
    TB_LAYOUT_VALUE(PHASE_FAULT_RESET)                                                             \
    TB_LAYOUT_VALUE(PHASE_READY)                                                                   \
    TB_LAYOUT_VALUE(PHASE_CABLE_MODE)                                                              \
    TB_LAYOUT_VALUE(PHASE_CABLE_POWER)                                                             \
    TB_LAYOUT_VALUE(PHASE_TIGHTEN)                                                                 \
    TB_LAYOUT_VALUE(PHASE_TRY_CABLES)                                                              \
    TB_LAYOUT_VALUE(PHASE_TRY_MODE)                                                                \
    TB_LAYOUT_VALUE(PHASE_TRY_POWER)                                                               \
    TB_LAYOUT_VALUE(PHASE_TRY_BASES)                                                               \
    TB_LAYOUT_VALUE(PHASE_TRY_RELEASE)                                                             \
    TB_LAYOUT_VALUE(PHASE_BASE_MODE)                                                               \
    TB_LAYOUT_VALUE(PHASE_BASE_POWER)                                                              \
    TB_LAYOUT_VALUE(PHASE_BASE_HOMING)                                                             \
    TB_LAYOUT_VALUE(PHASE_BASE_RELEASE)                                                            \
    TB_LAYOUT_VALUE(PHASE_BASE_WORK_MODE)                                                          \
    TB_LAYOUT_VALUE(PHASE_BASE_WORK_POWER)                                                         \
    TB_LAYOUT_VALUE(PHASE_GATHER)                                                                  \
    TB_LAYOUT_VALUE(PHASE_SWEEP)                                                                   \
    TB_LAYOUT_VALUE(PHASE_SOLVE)                                                                   \
    TB_LAYOUT_VALUE(PHASE_APPROACH)                                                                \
    TB_LAYOUT_VALUE(PHASE_CLOSE)                                                                   \
    TB_LAYOUT_VALUE(PHASE_RELAX)                                                                   \
    TB_LAYOUT_VALUE(PHASE_SLACKEN)                                                                 \
    TB_LAYOUT_VALUE(PHASE_POWER_OFF)                                                               \
    TB_LAYOUT_ENUMERATION(cause)                                                                   \
    TB_CAUSES(TB_LAYOUT_CAUSE)                                                                     \
    TB_LAYOUT_ENUMERATION(request)                                                                 \
    TB_LAYOUT_VALUE(REQUEST_ARM)                                                                   \
    TB_LAYOUT_VALUE(REQUEST_STOP)                                                                  \
    TB_LAYOUT_VALUE(REQUEST_RESET)                                                                 \
    TB_LAYOUT_ENUMERATION(power)                                                                   \
    TB_LAYOUT_VALUE(POWER_UNKNOWN)                                                                 \
    TB_LAYOUT_VALUE(POWER_NOT_READY)                                                               \
    TB_LAYOUT_VALUE(POWER_OFF)                                                                     \
    TB_LAYOUT_VALUE(POWER_READY)                                                                   \
    TB_LAYOUT_VALUE(POWER_ON)                                                                      \
    TB_LAYOUT_VALUE(POWER_ENABLED)                                                                 \
    TB_LAYOUT_VALUE(POWER_QUICK_STOP)                                                              \
    TB_LAYOUT_VALUE(POWER_FAULT_REACTION)                                                          \
    TB_LAYOUT_VALUE(POWER_FAULT)                                                                   \
    TB_LAYOUT_ENUMERATION(goal)                                                                    \
    TB_LAYOUT_VALUE(GOAL_OFF)                                                                      \
    TB_LAYOUT_VALUE(GOAL_READY)                                                                    \
    TB_LAYOUT_VALUE(GOAL_ENABLED)                                                                  \
    TB_LAYOUT_VALUE(GOAL_QUICK_STOP)                                                               \
    TB_LAYOUT_VALUE(GOAL_FAULT_RESET)                                                              \
    TB_LAYOUT_ENUMERATION(mode)                                                                    \
    TB_LAYOUT_VALUE(MODE_NONE)                                                                     \
    TB_LAYOUT_VALUE(MODE_TORQUE)                                                                   \
    TB_LAYOUT_VALUE(MODE_POSITION)                                                                 \
    TB_LAYOUT_VALUE(MODE_HOMING)                                                                   \
    TB_LAYOUT_ENUMERATION(homing)                                                                  \
    TB_LAYOUT_VALUE(HOMING_IDLE)                                                                   \
    TB_LAYOUT_VALUE(HOMING_RUNNING)                                                                \
    TB_LAYOUT_VALUE(HOMING_DONE)                                                                   \
    TB_LAYOUT_VALUE(HOMING_FAILED)                                                                 \
    TB_LAYOUT_ENUMERATION(task)                                                                    \
    TB_LAYOUT_VALUE(TASK_NONE)                                                                     \
    TB_LAYOUT_VALUE(TASK_RESET)                                                                    \
    TB_LAYOUT_VALUE(TASK_IDENTIFY)                                                                 \
    TB_LAYOUT_VALUE(TASK_CONFIGURE)                                                                \
    TB_LAYOUT_VALUE(TASK_START)                                                                    \
    TB_LAYOUT_VALUE(TASK_MODE)                                                                     \
    TB_LAYOUT_ENUMERATION(progress)                                                                \
    TB_LAYOUT_VALUE(TASK_IDLE)                                                                     \
    TB_LAYOUT_VALUE(TASK_BUSY)                                                                     \
    TB_LAYOUT_VALUE(TASK_DONE)                                                                     \
    TB_LAYOUT_VALUE(TASK_FAILED)                                                                   \
    TB_LAYOUT_ENUMERATION(failure)                                                                 \
    TB_LAYOUT_VALUE(FAILURE_NONE)                                                                  \
    TB_LAYOUT_VALUE(FAILURE_SILENT)                                                                \
    TB_LAYOUT_VALUE(FAILURE_ABORT)                                                                 \
    TB_LAYOUT_VALUE(FAILURE_DIFFERENT)                                                             \
    TB_LAYOUT_VALUE(FAILURE_TWICE)                                                                 \
    TB_LAYOUT_VALUE(FAILURE_SIZE)                                                                  \
    TB_LAYOUT_VALUE(FAILURE_RESTARTED)                                                             \
    TB_LAYOUT_ENUMERATION(silence)                                                                 \
    TB_LAYOUT_VALUE(SILENCE_NONE)                                                                  \
    TB_LAYOUT_VALUE(SILENCE_UNHEARD)                                                               \
    TB_LAYOUT_VALUE(SILENCE_LOCAL)                                                                 \
    TB_LAYOUT_ENUMERATION(bus_state)                                                               \
    TB_LAYOUT_VALUE(BUS_ACTIVE)                                                                    \
    TB_LAYOUT_VALUE(BUS_WARNING)                                                                   \
    TB_LAYOUT_VALUE(BUS_PASSIVE)                                                                   \
    TB_LAYOUT_VALUE(BUS_OFF)                                                                       \
    TB_LAYOUT_VALUE(BUS_NOT_OPEN)                                                                  \
    TB_LAYOUT_ENUMERATION(version)                                                                 \
    TB_LAYOUT_VALUE(RUNTIME_VERSION)

#endif

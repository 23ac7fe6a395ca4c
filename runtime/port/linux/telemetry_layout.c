#include "can_layout.h"
#include "cycle_layout.h"
#include "telemetry.h"

#define TELEMETRY_LAYOUT                                                                           \
    TB_LAYOUT_STRUCT(histogram)                                                                    \
    TB_LAYOUT_NUMBERS(histogram, bins)                                                             \
    TB_LAYOUT_NUMBER(histogram, count)                                                             \
    TB_LAYOUT_NUMBER(histogram, least)                                                             \
    TB_LAYOUT_NUMBER(histogram, most)                                                              \
    TB_LAYOUT_NUMBER(histogram, sum)                                                               \
    TB_LAYOUT_STRUCT(telemetry_header)                                                             \
    TB_LAYOUT_TEXT(telemetry_header, magic)                                                        \
    TB_LAYOUT_NUMBER(telemetry_header, version)                                                    \
    TB_LAYOUT_NUMBER(telemetry_header, bytes)                                                      \
    TB_LAYOUT_NUMBER(telemetry_header, layout_at)                                                  \
    TB_LAYOUT_NUMBER(telemetry_header, layout_rows)                                                \
    TB_LAYOUT_TEXT(telemetry_header, machine)                                                      \
    TB_LAYOUT_TEXT(telemetry_header, hash)                                                         \
    TB_LAYOUT_NUMBER(telemetry_header, dof)                                                        \
    TB_LAYOUT_NUMBER(telemetry_header, cables)                                                     \
    TB_LAYOUT_NUMBER(telemetry_header, rails)                                                      \
    TB_LAYOUT_NUMBER(telemetry_header, drives)                                                     \
    TB_LAYOUT_NUMBER(telemetry_header, buses)                                                      \
    TB_LAYOUT_NUMBER(telemetry_header, status_at)                                                  \
    TB_LAYOUT_NUMBER(telemetry_header, cycles_at)                                                  \
    TB_LAYOUT_NUMBER(telemetry_header, slots)                                                      \
    TB_LAYOUT_NUMBER(telemetry_header, inbox_at)                                                   \
    TB_LAYOUT_NUMBER(telemetry_header, pid)                                                        \
    TB_LAYOUT_NUMBER(telemetry_header, simulated)                                                  \
    TB_LAYOUT_NUMBER(telemetry_header, has_rails)                                                  \
    TB_LAYOUT_NUMBER(telemetry_header, period)                                                     \
    TB_LAYOUT_NUMBER(telemetry_header, tension_min)                                                \
    TB_LAYOUT_NUMBER(telemetry_header, tension_max)                                                \
    TB_LAYOUT_NUMBERS(telemetry_header, edges)                                                     \
    TB_LAYOUT_TEXTS(telemetry_header, drive_names)                                                 \
    TB_LAYOUT_TEXTS(telemetry_header, bus_names)                                                   \
    TB_LAYOUT_STRUCT(telemetry_bus)                                                                \
    TB_LAYOUT_NUMBER(telemetry_bus, bits)                                                          \
    TB_LAYOUT_NUMBER(telemetry_bus, state)                                                         \
    TB_LAYOUT_NUMBER(telemetry_bus, sent)                                                          \
    TB_LAYOUT_NUMBER(telemetry_bus, received)                                                      \
    TB_LAYOUT_NUMBER(telemetry_bus, refused)                                                       \
    TB_LAYOUT_NUMBER(telemetry_bus, lost)                                                          \
    TB_LAYOUT_NUMBER(telemetry_bus, malformed)                                                     \
    TB_LAYOUT_NUMBER(telemetry_bus, bus_errors)                                                    \
    TB_LAYOUT_NUMBER(telemetry_bus, bus_off)                                                       \
    TB_LAYOUT_NUMBER(telemetry_bus, bit_rate)                                                      \
    TB_LAYOUT_NUMBER(telemetry_bus, divider)                                                       \
    TB_LAYOUT_STRUCT(loop_times)                                                                   \
    TB_LAYOUT_NUMBER(loop_times, missed)                                                           \
    TB_LAYOUT_NUMBER(loop_times, longest_gap)                                                      \
    TB_LAYOUT_PART(loop_times, lateness, histogram)                                                \
    TB_LAYOUT_PART(loop_times, computing, histogram)                                               \
    TB_LAYOUT_STRUCT(telemetry_status)                                                             \
    TB_LAYOUT_NUMBER(telemetry_status, sequence)                                                   \
    TB_LAYOUT_NUMBER(telemetry_status, published)                                                  \
    TB_LAYOUT_PART(telemetry_status, times, loop_times)                                            \
    TB_LAYOUT_PARTS(telemetry_status, buses, telemetry_bus)                                        \
    TB_LAYOUT_TEXT(telemetry_status, doing)                                                        \
    TB_LAYOUT_TEXT(telemetry_status, cause)                                                        \
    TB_LAYOUT_STRUCT(telemetry_drive)                                                              \
    TB_LAYOUT_NUMBER(telemetry_drive, position)                                                    \
    TB_LAYOUT_NUMBER(telemetry_drive, torque)                                                      \
    TB_LAYOUT_NUMBER(telemetry_drive, ordered_torque)                                              \
    TB_LAYOUT_NUMBER(telemetry_drive, statusword)                                                  \
    TB_LAYOUT_NUMBER(telemetry_drive, error_code)                                                  \
    TB_LAYOUT_NUMBER(telemetry_drive, power)                                                       \
    TB_LAYOUT_NUMBER(telemetry_drive, mode)                                                        \
    TB_LAYOUT_NUMBER(telemetry_drive, homing)                                                      \
    TB_LAYOUT_NUMBER(telemetry_drive, fresh)                                                       \
    TB_LAYOUT_NUMBER(telemetry_drive, missed)                                                      \
    TB_LAYOUT_NUMBER(telemetry_drive, silent)                                                      \
    TB_LAYOUT_NUMBER(telemetry_drive, task)                                                        \
    TB_LAYOUT_NUMBER(telemetry_drive, progress)                                                    \
    TB_LAYOUT_NUMBER(telemetry_drive, goal)                                                        \
    TB_LAYOUT_NUMBERS(telemetry_drive, reserved)                                                   \
    TB_LAYOUT_STRUCT(telemetry_cycle)                                                              \
    TB_LAYOUT_NUMBER(telemetry_cycle, sequence)                                                    \
    TB_LAYOUT_NUMBER(telemetry_cycle, number)                                                      \
    TB_LAYOUT_NUMBER(telemetry_cycle, time)                                                        \
    TB_LAYOUT_NUMBER(telemetry_cycle, missed)                                                      \
    TB_LAYOUT_NUMBER(telemetry_cycle, requests)                                                    \
    TB_LAYOUT_NUMBER(telemetry_cycle, state)                                                       \
    TB_LAYOUT_NUMBER(telemetry_cycle, phase)                                                       \
    TB_LAYOUT_NUMBER(telemetry_cycle, cause)                                                       \
    TB_LAYOUT_NUMBER(telemetry_cycle, beat)                                                        \
    TB_LAYOUT_NUMBER(telemetry_cycle, status)                                                      \
    TB_LAYOUT_NUMBERS(telemetry_cycle, pose)                                                       \
    TB_LAYOUT_NUMBERS(telemetry_cycle, velocity)                                                   \
    TB_LAYOUT_NUMBER(telemetry_cycle, residual)                                                    \
    TB_LAYOUT_NUMBERS(telemetry_cycle, force)                                                      \
    TB_LAYOUT_NUMBERS(telemetry_cycle, wanted_force)                                               \
    TB_LAYOUT_NUMBERS(telemetry_cycle, delivered_force)                                            \
    TB_LAYOUT_NUMBERS(telemetry_cycle, tension)                                                    \
    TB_LAYOUT_NUMBERS(telemetry_cycle, slack)                                                      \
    TB_LAYOUT_NUMBERS(telemetry_cycle, rail_target)                                                \
    TB_LAYOUT_PARTS(telemetry_cycle, drives, telemetry_drive)                                      \
    TB_LAYOUT_STRUCT(telemetry_inbox)                                                              \
    TB_LAYOUT_NUMBER(telemetry_inbox, arm)                                                         \
    TB_LAYOUT_NUMBER(telemetry_inbox, stop)                                                        \
    TB_LAYOUT_NUMBER(telemetry_inbox, reset)                                                       \
    TB_LAYOUT_NUMBER(telemetry_inbox, reserved)                                                    \
    TB_LAYOUT_NUMBER(telemetry_inbox, force_sequence)                                              \
    TB_LAYOUT_NUMBERS(telemetry_inbox, force)                                                      \
    TB_LAYOUT_NUMBER(telemetry_inbox, hand_sequence)                                               \
    TB_LAYOUT_NUMBERS(telemetry_inbox, hand_force)

const tb_layout_row tb_telemetry_layout[] = {TELEMETRY_LAYOUT TB_ENUMERATIONS_LAYOUT TB_CAN_LAYOUT};

const uint32_t tb_telemetry_layout_rows =
    sizeof(tb_telemetry_layout) / sizeof(tb_telemetry_layout[0]);

_Static_assert(sizeof(tb_telemetry_layout) / sizeof(tb_telemetry_layout[0]) <= TB_TELEMETRY_ROWS,
               "the description needs more room");

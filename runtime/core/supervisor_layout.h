/* Rows of a description (layout.h): everything that the supervisor remembers. The rows of
 * TB_CYCLE_LAYOUT stand before these. */
#ifndef TB_SUPERVISOR_LAYOUT_H
#define TB_SUPERVISOR_LAYOUT_H

#include "cycle_layout.h"
#include "supervisor_memory.h"

#define TB_SUPERVISOR_LAYOUT                                                                       \
    TB_LAYOUT_STRUCT(blame)                                                                        \
    TB_LAYOUT_NUMBER(blame, detail)                                                                \
    TB_LAYOUT_NUMBER(blame, culprit)                                                               \
    TB_LAYOUT_NUMBER(blame, index)                                                                 \
    TB_LAYOUT_NUMBER(blame, subindex)                                                              \
    TB_LAYOUT_NUMBER(blame, failure)                                                               \
    TB_LAYOUT_NUMBER(blame, cause)                                                                 \
    TB_LAYOUT_STRUCT(drive_memory)                                                                 \
    TB_LAYOUT_PART(drive_memory, wanted, drive_order)                                              \
    TB_LAYOUT_NUMBER(drive_memory, sent)                                                           \
    TB_LAYOUT_NUMBER(drive_memory, released)                                                       \
    TB_LAYOUT_NUMBER(drive_memory, deaf)                                                           \
    TB_LAYOUT_NUMBER(drive_memory, online)                                                         \
    TB_LAYOUT_NUMBER(drive_memory, patience)                                                       \
    TB_LAYOUT_NUMBER(drive_memory, reached)                                                        \
    TB_LAYOUT_NUMBER(drive_memory, ran)                                                            \
    TB_LAYOUT_STRUCT(track)                                                                        \
    TB_LAYOUT_NUMBER(track, position)                                                              \
    TB_LAYOUT_NUMBER(track, rate)                                                                  \
    TB_LAYOUT_NUMBER(track, age)                                                                   \
    TB_LAYOUT_NUMBER(track, known)                                                                 \
    TB_LAYOUT_NUMBER(track, jumped)                                                                \
    TB_LAYOUT_STRUCT(measurement)                                                                  \
    TB_LAYOUT_PARTS(measurement, tracks, track)                                                    \
    TB_LAYOUT_STRUCT(trial)                                                                        \
    TB_LAYOUT_NUMBERS(trial, speed)                                                                \
    TB_LAYOUT_NUMBERS(trial, answer)                                                               \
    TB_LAYOUT_NUMBERS(trial, answered)                                                             \
    TB_LAYOUT_STRUCT(carriage)                                                                     \
    TB_LAYOUT_NUMBER(carriage, speed)                                                              \
    TB_LAYOUT_NUMBER(carriage, low)                                                                \
    TB_LAYOUT_NUMBER(carriage, high)                                                               \
    TB_LAYOUT_NUMBER(carriage, cycles)                                                             \
    TB_LAYOUT_NUMBER(carriage, pushed)                                                             \
    TB_LAYOUT_NUMBER(carriage, forward)                                                            \
    TB_LAYOUT_STRUCT(guide)                                                                        \
    TB_LAYOUT_NUMBERS(guide, reference)                                                            \
    TB_LAYOUT_NUMBERS(guide, base)                                                                 \
    TB_LAYOUT_NUMBERS(guide, lagging)                                                              \
    TB_LAYOUT_NUMBERS(guide, guided)                                                               \
    TB_LAYOUT_STRUCT(calibration)                                                                  \
    TB_LAYOUT_NUMBERS(calibration, wound)                                                          \
    TB_LAYOUT_NUMBERS(calibration, rails)                                                          \
    TB_LAYOUT_NUMBERS(calibration, poses)                                                          \
    TB_LAYOUT_NUMBERS(calibration, zeros)                                                          \
    TB_LAYOUT_NUMBER(calibration, residual)                                                        \
    TB_LAYOUT_NUMBER(calibration, spread)                                                          \
    TB_LAYOUT_NUMBER(calibration, count)                                                           \
    TB_LAYOUT_NUMBER(calibration, steps)                                                           \
    TB_LAYOUT_STRUCT(watch)                                                                        \
    TB_LAYOUT_NUMBER(watch, open)                                                                  \
    TB_LAYOUT_NUMBERS(watch, lagging)                                                              \
    TB_LAYOUT_STRUCT(supervisor)                                                                   \
    TB_LAYOUT_NUMBER(supervisor, state)                                                            \
    TB_LAYOUT_NUMBER(supervisor, complement)                                                       \
    TB_LAYOUT_NUMBER(supervisor, phase)                                                            \
    TB_LAYOUT_NUMBER(supervisor, damaged)                                                          \
    TB_LAYOUT_NUMBER(supervisor, cycles)                                                           \
    TB_LAYOUT_NUMBER(supervisor, calm)                                                             \
    TB_LAYOUT_NUMBER(supervisor, failed)                                                           \
    TB_LAYOUT_NUMBER(supervisor, requests)                                                         \
    TB_LAYOUT_PART(supervisor, first, blame)                                                       \
    TB_LAYOUT_PARTS(supervisor, drives, drive_memory)                                              \
    TB_LAYOUT_NUMBERS(supervisor, corrupt)                                                         \
    TB_LAYOUT_NUMBERS(supervisor, spoiled)                                                         \
    TB_LAYOUT_PART(supervisor, measurement, measurement)                                           \
    TB_LAYOUT_PART(supervisor, trial, trial)                                                       \
    TB_LAYOUT_PARTS(supervisor, carriages, carriage)                                               \
    TB_LAYOUT_PART(supervisor, guide, guide)                                                       \
    TB_LAYOUT_PART(supervisor, calibration, calibration)                                           \
    TB_LAYOUT_PART(supervisor, watch, watch)                                                       \
    TB_LAYOUT_PART(supervisor, controller, controller)                                             \
    TB_LAYOUT_PART(supervisor, outputs, outputs)                                                   \
    TB_LAYOUT_NUMBERS(supervisor, slack)

#endif

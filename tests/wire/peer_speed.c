/* Prints how many times faster than real time eight drives on four buses run at 1 kHz. */
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "peer_drives.h"

enum { BUSES = 4, DRIVES = 8, CYCLES = 5000, MILLISECOND = 1000000 };

static peer_time now;

static void clear_inboxes(peer *const p)
{
    peer_frame frame;
    peer_time time;
    for (uint32_t b = 0; b < BUSES; b++) {
        while (peer_receive(p, b, &frame, &time)) {
        }
    }
}

static void pass_millisecond(peer *const p)
{
    now = peer_run(p, now + MILLISECOND);
    clear_inboxes(p);
}

static void write_object(peer *const p, uint32_t const drive, uint32_t const object,
                         uint32_t const value)
{
    uint32_t const size = (object & 0xFFU) / 8;
    uint8_t const command = (uint8_t)(0x23U | (4U - size) << 2);
    peer_frame frame = {.id = 0x601 + drive,
                        .length = 8,
                        .data = {command, (uint8_t)(object >> 16), (uint8_t)(object >> 24),
                                 (uint8_t)(object >> 8)}};
    for (uint32_t i = 0; i < 4; i++) {
        frame.data[4 + i] = (uint8_t)(value >> 8 * i);
    }
    (void)peer_send(p, drive / 2, now, &frame);
    pass_millisecond(p);
}

/* Controlword and target torque with every SYNC; statusword and position back. */
static void configure(peer *const p, uint32_t const drive)
{
    uint32_t const receive = 0x201 + drive;
    uint32_t const send = 0x40000181 + drive;
    uint32_t const writes[][2] = {{0x14000120, receive | 0x80000000U},
                                  {0x14000208, 1},
                                  {0x16000008, 0},
                                  {0x16000120, 0x60400010},
                                  {0x16000220, 0x60710010},
                                  {0x16000008, 2},
                                  {0x14000120, receive},
                                  {0x18000120, send | 0x80000000U},
                                  {0x18000208, 1},
                                  {0x1A000008, 0},
                                  {0x1A000120, 0x60410010},
                                  {0x1A000220, 0x60640020},
                                  {0x1A000008, 2},
                                  {0x18000120, send},
                                  {0x60600008, 10}};
    for (size_t i = 0; i < sizeof writes / sizeof writes[0]; i++) {
        write_object(p, drive, writes[i][0], writes[i][1]);
    }
}

static double cycle(peer *const p, int const k)
{
    peer_frame const sync = {.id = 0x080};
    uint8_t const word = k < 10 ? 6 : k < 20 ? 7 : 15;
    double torque = 0.0;
    for (uint32_t b = 0; b < BUSES; b++) {
        (void)peer_send(p, b, now, &sync);
    }
    for (uint32_t d = 0; d < DRIVES; d++) {
        peer_frame const frame = {.id = 0x201 + d, .length = 4, .data = {word, 0, (uint8_t)k, 0}};
        (void)peer_send(p, d / 2, now, &frame);
        peer_turn(p, d, now + MILLISECOND, 1e-3 * k);
    }
    pass_millisecond(p);
    for (uint32_t d = 0; d < DRIVES; d++) {
        torque += peer_torque(p, d);
    }
    return torque;
}

static peer *new_drives(void)
{
    static peer_bus buses[BUSES];
    static peer_drive drives[DRIVES];
    for (uint32_t b = 0; b < BUSES; b++) {
        buses[b].bit_rate = 1000000;
    }
    for (uint32_t d = 0; d < DRIVES; d++) {
        drives[d] = (peer_drive){.bus = d / 2,
                                 .node = d + 1,
                                 .counts_per_turn = 4096,
                                 .nominal_current = 3000,
                                 .current_limit = 6000,
                                 .torque_constant = 30000,
                                 .rotor_inertia = 1e-5};
    }
    peer_config const config = {BUSES, DRIVES, buses, drives, {.answer_delay = 50000, .seed = 1}};
    return peer_new(&config);
}

int main(void)
{
    peer *const p = new_drives();
    if (p == NULL) {
        return 1;
    }
    pass_millisecond(p);
    for (uint32_t d = 0; d < DRIVES; d++) {
        configure(p, d);
    }
    peer_frame const start = {.id = 0, .length = 2, .data = {1, 0}};
    for (uint32_t b = 0; b < BUSES; b++) {
        (void)peer_send(p, b, now, &start);
    }
    pass_millisecond(p);
    clock_t const begin = clock();
    double torque = 0.0;
    for (int k = 0; k < CYCLES; k++) {
        torque += cycle(p, k);
    }
    double const spent = (double)(clock() - begin) / CLOCKS_PER_SEC;
    bool const works = torque > 0.0 && peer_counted(p, DRIVES - 1).setpoints == CYCLES &&
                       peer_power_state(p, 0) == PEER_OPERATION_ENABLED;
    printf("%.0f\n", CYCLES / 1000.0 / spent);
    peer_free(p);
    return works ? 0 : 1;
}

#include "reopening.h"

#include <stdio.h>
#include <string.h>

#include "say.h"
#include "supervisor.h"

#define LONGEST_SENTENCE (TB_LONGEST_DEVICE + 160)

static bool is_lost(const tb_reopening *reopening, size_t bus)
{
    return tb_can_port_state(reopening->buses->ports[bus]) == TB_CAN_NOT_OPEN;
}

/* ---- Words ---- */

static void word(const tb_reopening *reopening, size_t bus, size_t room, char text[])
{
    char device[TB_LONGEST_DEVICE + 1];
    tb_buses_name(&reopening->options->buses[bus], sizeof device, device);
    switch (reopening->presence[bus]) {
    case TB_BUS_REFUSED:
        snprintf(text, room, "%s cannot be opened again: %s; then reset once more", device,
                 tb_can_result_text(reopening->why[bus]));
        break;
    case TB_BUS_OPENING:
        snprintf(text, room, "%s is being opened again", device);
        break;
    case TB_BUS_GONE:
        snprintf(text, room, "%s has gone: %s", device,
                 reopening->options->seal
                     ? "bring it back, then start the program again: sealed, it opens nothing"
                     : "bring it back, then reset: that opens it again");
        break;
    default:
        snprintf(text, room, "%s is open again", device);
        break;
    }
}

static void say(const tb_reopening *reopening, size_t bus)
{
    char text[LONGEST_SENTENCE];
    word(reopening, bus, sizeof text, text);
    tb_say("bus %s: %s", tb_buses[bus].name, text);
}

void tb_reopening_tell(const tb_reopening *reopening, size_t room, char text[])
{
    char sentence[LONGEST_SENTENCE];
    size_t bus = 0;
    while ((bus < TB_BUSES) && (reopening->presence[bus] == TB_BUS_PRESENT)) {
        bus++;
    }
    if (bus < TB_BUSES) {
        size_t const used = strlen(text);
        word(reopening, bus, sizeof sentence, sentence);
        snprintf(text + used, room - used, "; %s", sentence);
    }
}

/* ---- Deeds ---- */

static void give_back(tb_reopening *reopening)
{
    for (size_t i = 0; i < TB_BUSES; i++) {
        if ((reopening->presence[i] == TB_BUS_PRESENT) && is_lost(reopening, i)) {
            tb_can_close(reopening->buses->ports[i]);
            reopening->presence[i] = TB_BUS_GONE;
            say(reopening, i);
        }
    }
}

static void settle(tb_reopening *reopening, size_t bus, tb_can_result result)
{
    if (result == TB_CAN_EMPTY) {
        reopening->presence[bus] = TB_BUS_OPENING;
        return;
    }
    reopening->why[bus] = result;
    reopening->presence[bus] = (result == TB_CAN_OK) ? TB_BUS_PRESENT : TB_BUS_REFUSED;
    say(reopening, bus);
}

static void begin(tb_reopening *reopening)
{
    for (size_t i = 0; i < TB_BUSES; i++) {
        tb_bus_presence const presence = reopening->presence[i];
        if ((presence == TB_BUS_GONE) || (presence == TB_BUS_REFUSED)) {
            const tb_bus_option *const option = &reopening->options->buses[i];
            settle(reopening, i, tb_buses_begin(reopening->buses, i, option));
        }
    }
}

/* Whether any bus is still being opened. */
static bool proceed(tb_reopening *reopening)
{
    bool under_way = false;
    for (size_t i = 0; i < TB_BUSES; i++) {
        if (reopening->presence[i] == TB_BUS_OPENING) {
            tb_can_result const result =
                tb_buses_proceed(reopening->buses, i, &reopening->options->buses[i]);
            if (result != TB_CAN_EMPTY) {
                settle(reopening, i, result);
            }
            under_way = under_way || (result == TB_CAN_EMPTY);
        }
    }
    return under_way;
}

static bool is_under_way(const tb_reopening *reopening)
{
    bool under_way = false;
    for (size_t i = 0; i < TB_BUSES; i++) {
        under_way = under_way || (reopening->presence[i] == TB_BUS_OPENING);
    }
    return under_way;
}

uint32_t tb_reopen(tb_reopening *reopening, uint8_t state, uint32_t requests)
{
    if (state != TB_STATE_FAULT) {
        return requests;
    }
    bool const waits = is_under_way(reopening);
    bool const asked = (requests & TB_REQUEST_RESET) != 0;
    give_back(reopening);
    if (asked && !waits && !reopening->options->seal) {
        begin(reopening);
    }
    if (proceed(reopening)) {
        return requests & ~TB_REQUEST_RESET;
    }
    return requests | (waits ? TB_REQUEST_RESET : 0u);
}

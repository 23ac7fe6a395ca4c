/* Fuzz target: any answers to an SDO client.
 *
 * The first three bytes choose the transfer: its kind, its size, the time-out. Every nine bytes after
 * that are a step: the first says how many cycles pass, the rest is an answer. What must hold: no byte
 * beyond the room is written or beyond the data read (the address sanitizer watches); at most one
 * request is out; the transfer ends in bounded steps once nothing answers; the client can begin anew;
 * answers to requests that it gave up, as many as those, are no second drive's. */
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "sdo.h"

#define STEP 9u

static void require(bool condition)
{
    if (!condition) {
        __builtin_trap();
    }
}

static void begin(tb_sdo_client *client, bool reads, uint8_t *data, uint32_t size)
{
    if (reads) {
        tb_sdo_upload(client, 0x2000, 1, data, size);
    } else {
        tb_sdo_download(client, 0x2000, 1, data, size);
    }
}

/* Sends what there is to send: an abort, and a request at most. */
static void send_all(tb_sdo_client *client)
{
    tb_can_frame frame;
    for (size_t i = 0; tb_sdo_frame(client, &frame); i++) {
        require(i < 2u);
        require((frame.id == 0x605u) && (frame.length == 8u) && (frame.flags == 0));
    }
}

static void answer(tb_sdo_client *client, const uint8_t step[STEP])
{
    tb_can_frame frame = {.id = 0x585u, .length = (uint8_t)(((step[0] & 0x0Fu) == 1u) ? 7u : 8u)};
    memcpy(frame.data, &step[1], 8);
    for (uint32_t i = 0; i < (step[0] >> 4); i++) {
        tb_sdo_tick(client);
    }
    require(tb_sdo_take(client, &frame) == (frame.length == 8u));
}

static void check(const tb_sdo_client *client, uint32_t size)
{
    require(client->done <= size);
    require(client->result <= TB_SDO_SILENT);
    require((client->toggle & ~0x10u) == 0);
    require((client->result != TB_SDO_DONE) || (client->done <= size));
}

static void check_end(tb_sdo_client *client)
{
    for (uint32_t i = 0; i <= (client->timeout + 1u); i++) {
        tb_sdo_tick(client);
    }
    require(client->result != TB_SDO_BUSY);
    send_all(client);
}

/* Requests that time out, each repeated; then all answers at once. */
static void check_late_answers(tb_sdo_client *client, uint8_t *object, uint32_t requests)
{
    tb_can_frame const frame = {.id = 0x585u, .length = 8, .data = {0x80u, 0x00u, 0x20u, 1}};
    tb_sdo_start(client, 5, 3);
    for (uint32_t i = 0; i < requests; i++) {
        tb_sdo_upload(client, 0x2000, 1, object, 0);
        send_all(client);
        check_end(client);
    }
    for (uint32_t i = 0; i < requests; i++) {
        require(client->extra == 0);
        (void)tb_sdo_take(client, &frame);
    }
    require(client->extra == 0);
    (void)tb_sdo_take(client, &frame);
    require(client->extra == 1u);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size < 3u) {
        return 0;
    }
    bool const reads = (data[0] & 1u) != 0;
    uint32_t const room = data[1];
    uint8_t *const bytes = malloc(room + 1u); /* of its own, so that the sanitizer knows its end */
    uint8_t *const object = &bytes[1];
    tb_sdo_client client;
    memset(bytes, 0x5A, room + 1u);
    tb_sdo_start(&client, 5, data[2]);
    begin(&client, reads, object, room);
    for (size_t at = 3; (at + STEP) <= size; at += STEP) {
        send_all(&client);
        answer(&client, &data[at]);
        check(&client, room);
        if ((data[at] & 0x0Fu) == 2u) {
            tb_sdo_cancel(&client);
            begin(&client, !reads, object, room);
        }
    }
    check_end(&client);
    begin(&client, true, object, room);
    send_all(&client);
    require(client.result == TB_SDO_BUSY);
    require(tb_sdo_abort_text(client.code)[0] != '\0');
    check_late_answers(&client, object, data[0] >> 5);
    free(bytes);
    return 0;
}

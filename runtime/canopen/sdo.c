#include "sdo.h"

#include <stddef.h>
#include <string.h>

#include "cob.h"
#include "little_endian.h"

#define SDO_LENGTH 8
#define EXPEDITED_MOST 4u
#define SEGMENT_MOST 7u

/* Command byte: the upper three bits say what it is, the rest depends on it. */
#define COMMAND_CLASS(byte) ((uint8_t)((byte) >> 5))
#define REQUEST_DOWNLOAD 0x20u
#define REQUEST_UPLOAD 0x40u
#define REQUEST_UPLOAD_SEGMENT 0x60u
#define ABORT 0x80u
#define EXPEDITED 0x02u
#define SIZE_INDICATED 0x01u
#define TOGGLE 0x10u
#define LAST_SEGMENT 0x01u

/* What is requested and answered next */
enum { INITIATE_DOWNLOAD = 0, DOWNLOAD_SEGMENT, INITIATE_UPLOAD, UPLOAD_SEGMENT };

/* Class of the answer to each of them */
static const uint8_t answer_classes[] = {
    [INITIATE_DOWNLOAD] = 3,
    [DOWNLOAD_SEGMENT] = 1,
    [INITIATE_UPLOAD] = 2,
    [UPLOAD_SEGMENT] = 0,
};

static const tb_sdo_client no_transfer;

static uint32_t smaller(uint32_t a, uint32_t b)
{
    return (a < b) ? a : b;
}

/* ---- Requests ---- */

static void begin(tb_sdo_client *client, uint8_t step, uint16_t index, uint8_t subindex)
{
    client->index = index;
    client->subindex = subindex;
    client->step = step;
    client->done = 0;
    client->toggle = 0;
    client->sized = 0;
    client->waited = 0;
    client->to_send = 1;
    client->result = TB_SDO_BUSY;
}

void tb_sdo_start(tb_sdo_client *client, uint8_t node, uint32_t timeout)
{
    *client = no_transfer;
    client->node = node;
    client->timeout = timeout;
}

void tb_sdo_download(tb_sdo_client *client, uint16_t index, uint8_t subindex, const uint8_t data[],
                     uint32_t size)
{
    client->source = data;
    client->size = size;
    begin(client, INITIATE_DOWNLOAD, index, subindex);
}

void tb_sdo_upload(tb_sdo_client *client, uint16_t index, uint8_t subindex, uint8_t data[],
                   uint32_t room)
{
    client->target = data;
    client->room = room;
    begin(client, INITIATE_UPLOAD, index, subindex);
}

static void name_object(const tb_sdo_client *client, uint8_t data[])
{
    tb_put_u16(&data[1], client->index);
    data[3] = client->subindex;
}

static void write_download(const tb_sdo_client *client, uint8_t data[])
{
    name_object(client, data);
    if ((client->size == 0) || (client->size > EXPEDITED_MOST)) {
        data[0] = REQUEST_DOWNLOAD | SIZE_INDICATED;
        tb_put_u32(&data[4], client->size);
    } else {
        uint32_t const unused = EXPEDITED_MOST - client->size;
        data[0] = (uint8_t)(REQUEST_DOWNLOAD | EXPEDITED | SIZE_INDICATED | (unused << 2));
        memcpy(&data[4], client->source, client->size);
    }
}

static void write_segment(const tb_sdo_client *client, uint8_t data[])
{
    uint32_t const left = client->size - client->done;
    uint32_t const count = smaller(left, SEGMENT_MOST);
    uint32_t const last = (left == count) ? LAST_SEGMENT : 0;
    data[0] = (uint8_t)(client->toggle | ((SEGMENT_MOST - count) << 1) | last);
    memcpy(&data[1], &client->source[client->done], count);
}

static void write_request(const tb_sdo_client *client, uint8_t data[])
{
    switch (client->step) {
    case INITIATE_DOWNLOAD:
        write_download(client, data);
        break;
    case DOWNLOAD_SEGMENT:
        write_segment(client, data);
        break;
    case INITIATE_UPLOAD:
        data[0] = REQUEST_UPLOAD;
        name_object(client, data);
        break;
    default:
        data[0] = (uint8_t)(REQUEST_UPLOAD_SEGMENT | client->toggle);
        break;
    }
}

static void write_abort(const tb_sdo_client *client, uint8_t data[])
{
    data[0] = ABORT;
    name_object(client, data);
    tb_put_u32(&data[4], client->code);
}

bool tb_sdo_frame(tb_sdo_client *client, tb_can_frame *frame)
{
    bool const requests = (client->result == TB_SDO_BUSY) && (client->to_send != 0);
    *frame = tb_cob_frame(TB_COB_SDO_REQUEST, client->node, SDO_LENGTH);
    if (client->aborting != 0) {
        client->aborting = 0;
        write_abort(client, frame->data);
        return true;
    }
    if (requests) {
        client->to_send = 0;
        client->waited = 0;
        write_request(client, frame->data);
    }
    return requests;
}

/* ---- Ends ---- */

static bool awaits_answer(const tb_sdo_client *client)
{
    return (client->result == TB_SDO_BUSY) && (client->to_send == 0);
}

static void count_up(uint8_t *count)
{
    *count = (*count < UINT8_MAX) ? (uint8_t)(*count + 1u) : *count;
}

/* The answer to what is out now may still come. */
static void note_owed(tb_sdo_client *client)
{
    if (awaits_answer(client)) {
        count_up(&client->owed);
    }
}

static void give_up(tb_sdo_client *client, tb_sdo_result result, uint32_t code)
{
    client->result = (uint8_t)result;
    client->code = code;
    client->aborting = 1;
}

void tb_sdo_cancel(tb_sdo_client *client)
{
    if (awaits_answer(client)) {
        note_owed(client);
        give_up(client, TB_SDO_IDLE, TB_SDO_ABORT_GENERAL);
    }
    client->result = TB_SDO_IDLE;
}

void tb_sdo_tick(tb_sdo_client *client)
{
    if (client->result != TB_SDO_BUSY) {
        return;
    }
    client->waited++;
    if (client->waited > client->timeout) {
        note_owed(client);
        give_up(client, TB_SDO_SILENT, TB_SDO_ABORT_TIMEOUT);
    }
}

/* ---- Answers ---- */

static void request_next(tb_sdo_client *client, uint8_t step)
{
    client->step = step;
    client->to_send = 1;
    client->waited = 0;
}

static void take_download(tb_sdo_client *client)
{
    if ((client->size == 0) || (client->size > EXPEDITED_MOST)) {
        request_next(client, DOWNLOAD_SEGMENT);
    } else {
        client->done = client->size;
        client->result = TB_SDO_DONE;
    }
}

static void take_download_segment(tb_sdo_client *client, const uint8_t data[])
{
    if ((data[0] & TOGGLE) != client->toggle) {
        give_up(client, TB_SDO_BROKEN, TB_SDO_ABORT_TOGGLE);
        return;
    }
    client->toggle ^= TOGGLE;
    client->done += smaller(client->size - client->done, SEGMENT_MOST);
    if (client->done == client->size) {
        client->result = TB_SDO_DONE;
    } else {
        request_next(client, DOWNLOAD_SEGMENT);
    }
}

static void take_expedited(tb_sdo_client *client, const uint8_t data[])
{
    client->sized = data[0] & SIZE_INDICATED;
    uint32_t const unused = (client->sized != 0) ? ((data[0] >> 2) & 3u) : 0u;
    uint32_t const count = EXPEDITED_MOST - unused;
    if (count > client->room) {
        give_up(client, TB_SDO_BROKEN, TB_SDO_ABORT_MEMORY);
        return;
    }
    memcpy(client->target, &data[4], count);
    client->done = count;
    client->result = TB_SDO_DONE;
}

static void take_upload(tb_sdo_client *client, const uint8_t data[])
{
    if ((data[0] & EXPEDITED) != 0) {
        take_expedited(client, data);
        return;
    }
    client->sized = data[0] & SIZE_INDICATED;
    client->size = (client->sized != 0) ? tb_get_u32(&data[4]) : client->room;
    if (client->size > client->room) {
        give_up(client, TB_SDO_BROKEN, TB_SDO_ABORT_MEMORY);
    } else {
        request_next(client, UPLOAD_SEGMENT);
    }
}

/* Bytes of a segment. The last one need not tell them where the server said how many there are. */
static uint32_t count_segment(const tb_sdo_client *client, const uint8_t data[])
{
    uint32_t const unused = (data[0] >> 1) & 7u;
    uint32_t const left = client->size - client->done;
    bool const is_last = (data[0] & LAST_SEGMENT) != 0;
    bool const is_untold = is_last && (unused == 0) && (client->sized != 0) && (left > 0);
    return is_untold ? smaller(left, SEGMENT_MOST) : (SEGMENT_MOST - unused);
}

/* What is wrong with a segment of an upload; 0 for nothing. */
static uint32_t refuse_segment(const tb_sdo_client *client, const uint8_t data[], uint32_t count)
{
    bool const is_last = (data[0] & LAST_SEGMENT) != 0;
    bool const is_sized = client->sized != 0;
    uint32_t const left = client->size - client->done;
    if ((data[0] & TOGGLE) != client->toggle) {
        return TB_SDO_ABORT_TOGGLE;
    }
    if ((count == 0) && !is_last) {
        return TB_SDO_ABORT_COMMAND; /* nothing, and so on for ever */
    }
    if (count > left) {
        return is_sized ? TB_SDO_ABORT_LENGTH : TB_SDO_ABORT_MEMORY;
    }
    return (is_last && is_sized && (count < left)) ? TB_SDO_ABORT_LENGTH : 0;
}

static void take_upload_segment(tb_sdo_client *client, const uint8_t data[])
{
    uint32_t const count = count_segment(client, data);
    uint32_t const wrong = refuse_segment(client, data, count);
    if (wrong != 0) {
        give_up(client, TB_SDO_BROKEN, wrong);
        return;
    }
    memcpy(&client->target[client->done], &data[1], count);
    client->done += count;
    client->toggle ^= TOGGLE;
    if ((data[0] & LAST_SEGMENT) != 0) {
        client->sized = (count < SEGMENT_MOST) ? 1 : client->sized;
        client->result = TB_SDO_DONE;
    } else {
        request_next(client, UPLOAD_SEGMENT);
    }
}

static void take_awaited(tb_sdo_client *client, const uint8_t data[])
{
    memcpy(client->answer, data, sizeof client->answer);
    if (COMMAND_CLASS(data[0]) == COMMAND_CLASS(ABORT)) {
        client->code = tb_get_u32(&data[4]);
        client->result = TB_SDO_REFUSED;
        return;
    }
    switch (client->step) {
    case INITIATE_DOWNLOAD:
        take_download(client);
        break;
    case DOWNLOAD_SEGMENT:
        take_download_segment(client, data);
        break;
    case INITIATE_UPLOAD:
        take_upload(client, data);
        break;
    default:
        take_upload_segment(client, data);
        break;
    }
}

static bool names_object(const tb_sdo_client *client, const uint8_t data[])
{
    return (tb_get_u16(&data[1]) == client->index) && (data[3] == client->subindex);
}

/* Segments do not say which object they are of. */
static bool has_object(const uint8_t data[])
{
    return COMMAND_CLASS(data[0]) >= 2;
}

static bool is_of_awaited_class(const tb_sdo_client *client, const uint8_t data[])
{
    uint8_t const class = COMMAND_CLASS(data[0]);
    return (class == answer_classes[client->step]) || (class == COMMAND_CLASS(ABORT));
}

static bool is_awaited(const tb_sdo_client *client, const uint8_t data[])
{
    return is_of_awaited_class(client, data) && (!has_object(data) || names_object(client, data));
}

/* The same answer once more, from a second drive with the same number. */
static bool is_repeated(const tb_sdo_client *client, const uint8_t data[])
{
    return has_object(data) && (COMMAND_CLASS(data[0]) == COMMAND_CLASS(client->answer[0])) &&
           (memcmp(&data[1], &client->answer[1], 3) == 0);
}

static void take_unasked(tb_sdo_client *client)
{
    if (client->owed != 0) {
        client->owed--;
    } else {
        count_up(&client->extra);
    }
}

static void take_wrong(tb_sdo_client *client, const uint8_t data[])
{
    if ((client->owed != 0) || is_repeated(client, data)) {
        take_unasked(client);
    } else {
        bool const is_command_right = is_of_awaited_class(client, data);
        give_up(client, TB_SDO_BROKEN,
                is_command_right ? TB_SDO_ABORT_GENERAL : TB_SDO_ABORT_COMMAND);
    }
}

bool tb_sdo_take(tb_sdo_client *client, const tb_can_frame *frame)
{
    if (frame->length != SDO_LENGTH) {
        return false;
    }
    if (!awaits_answer(client)) {
        take_unasked(client);
    } else if (is_awaited(client, frame->data)) {
        take_awaited(client, frame->data);
    } else {
        take_wrong(client, frame->data);
    }
    return true;
}

/* ---- Words ---- */

typedef struct {
    uint32_t code;
    const char *text;
} tb_abort_text;

/* CiA 301 table 22 */
static const tb_abort_text abort_texts[] = {
    {TB_SDO_ABORT_TOGGLE, "toggle bit did not alternate"},
    {TB_SDO_ABORT_TIMEOUT, "transfer timed out"},
    {TB_SDO_ABORT_COMMAND, "command unknown or not valid"},
    {0x05040002, "block size not valid"},
    {0x05040003, "sequence number not valid"},
    {0x05040004, "checksum error"},
    {TB_SDO_ABORT_MEMORY, "out of memory"},
    {0x06010000, "access not supported"},
    {0x06010001, "object can only be written"},
    {0x06010002, "object can only be read"},
    {0x06020000, "object does not exist"},
    {0x06040041, "object cannot be mapped to a PDO"},
    {0x06040042, "mapped objects are longer than a PDO"},
    {0x06040043, "parameters are not compatible"},
    {0x06040047, "device is not compatible in itself"},
    {0x06060000, "hardware error"},
    {TB_SDO_ABORT_LENGTH, "length does not match"},
    {0x06070012, "too long"},
    {0x06070013, "too short"},
    {0x06090011, "subindex does not exist"},
    {0x06090030, "value out of range"},
    {0x06090031, "value too high"},
    {0x06090032, "value too low"},
    {0x06090036, "maximum is less than minimum"},
    {0x060A0023, "resource not available"},
    {TB_SDO_ABORT_GENERAL, "general error"},
    {0x08000020, "data cannot be stored"},
    {0x08000021, "data cannot be stored: local control"},
    {0x08000022, "data cannot be stored in this state of the device"},
    {0x08000023, "no object dictionary"},
    {0x08000024, "no data available"}};

static const char unknown_abort[] = "unknown abort code";

const char *tb_sdo_abort_text(uint32_t code)
{
    for (size_t i = 0; i < (sizeof abort_texts / sizeof abort_texts[0]); i++) {
        if (abort_texts[i].code == code) {
            return abort_texts[i].text;
        }
    }
    return unknown_abort;
}

/* The SDO server of a drive: expedited and segmented transfers (CiA 301, 7.2.4). */
#include "peer.h"

enum { COMMAND = 7 << 5, DOWNLOAD_SEGMENT = 0, DOWNLOAD = 1 << 5, UPLOAD = 2 << 5, ABORT = 4 << 5 };
enum { UPLOAD_SEGMENT = 3 << 5, EXPEDITED = 2, SIZED = 1, TOGGLE = 0x10, LAST = 1 };

static void answer(drive *const d, uint8_t const *const data)
{
    drive_transmit(d, 0x580 + d->config.node, data, 8, d->peer->now);
}

static void put32(uint8_t *const to, uint32_t const value)
{
    for (unsigned i = 0; i < 4; i++) {
        to[i] = (uint8_t)(value >> 8 * i);
    }
}

static uint32_t get32(uint8_t const *const from, unsigned const bytes)
{
    uint32_t value = 0;
    for (unsigned i = 0; i < bytes && i < 4; i++) {
        value |= (uint32_t)from[i] << 8 * i;
    }
    return value;
}

static void abort_transfer(drive *const d, uint8_t const *const object_bytes3, uint32_t const code)
{
    uint8_t data[8] = {0x80, object_bytes3[0], object_bytes3[1], object_bytes3[2]};
    put32(&data[4], code);
    d->sdo.transfer.kind = SDO_IDLE;
    answer(d, data);
}

/* Index and sub-index of the transfer's object, as they go into a message. */
static void multiplexer(int const slot, uint8_t *const to)
{
    to[0] = (uint8_t)objects[slot].index;
    to[1] = (uint8_t)(objects[slot].index >> 8);
    to[2] = objects[slot].sub;
}

static void abort_running(drive *const d, uint32_t const code)
{
    uint8_t object[3] = {0, 0, 0};
    if (d->sdo.transfer.kind != SDO_IDLE) {
        multiplexer(d->sdo.transfer.slot, object);
    }
    abort_transfer(d, object, code);
}

/* The slot a request is for; 0 or why there is none. */
static uint32_t find(drive const *const d, uint8_t const *const request, int *const slot)
{
    uint16_t const index = (uint16_t)(request[1] | request[2] << 8);
    peer_variation const *const v = &d->config.variation;
    if (v->abort_code != 0 && v->abort_index == index && v->abort_sub == request[3]) {
        return v->abort_code;
    }
    *slot = object_find(index, request[3]);
    if (*slot != NO_SLOT) {
        return ABORT_NONE;
    }
    return object_exists(index) ? ABORT_NO_SUB : ABORT_NO_OBJECT;
}

static int64_t extended_sign(int const slot, uint32_t const bits)
{
    switch (objects[slot].type) {
    case I8: return (int8_t)bits;
    case I16: return (int16_t)bits;
    case I32: return (int32_t)bits;
    default: return bits;
    }
}

static uint32_t length_fault(int const slot, uint32_t const bytes)
{
    if (objects[slot].type == STRING || bytes == object_bytes(slot)) {
        return ABORT_NONE;
    }
    return bytes > object_bytes(slot) ? ABORT_TOO_LONG : ABORT_TOO_SHORT;
}

static uint32_t store(drive *const d, int const slot, uint8_t const *const data,
                      uint32_t const bytes)
{
    uint32_t const fault = length_fault(slot, bytes);
    if (fault != ABORT_NONE) {
        return fault;
    }
    return object_write(d, slot, extended_sign(slot, get32(data, bytes)));
}

static void download_done(drive *const d, uint8_t const *const request)
{
    uint8_t const data[8] = {0x60, request[1], request[2], request[3]};
    answer(d, data);
}

static uint32_t begin_download(drive *const d, uint8_t const *const request, int const slot)
{
    bool const sized = (request[0] & SIZED) != 0;
    if ((request[0] & EXPEDITED) != 0) {
        uint32_t const given = 4U - (request[0] >> 2 & 3U);
        return store(d, slot, &request[4], sized ? given : object_bytes(slot));
    }
    if (sized && length_fault(slot, get32(&request[4], 4)) != ABORT_NONE) {
        return length_fault(slot, get32(&request[4], 4));
    }
    d->sdo.transfer = (transfer){.kind = SDO_DOWNLOAD,
                                 .slot = slot,
                                 .sized = sized,
                                 .size = sized ? get32(&request[4], 4) : 0};
    return ABORT_NONE;
}

static void download(drive *const d, uint8_t const *const request)
{
    int slot = NO_SLOT;
    d->sdo.transfer.kind = SDO_IDLE;
    uint32_t code = find(d, request, &slot);
    if (code == ABORT_NONE) {
        code = begin_download(d, request, slot);
    }
    if (code == ABORT_NONE) {
        download_done(d, request);
    } else {
        abort_transfer(d, &request[1], code);
    }
}

static uint8_t toggle_answered(drive const *const d, uint8_t const toggle)
{
    return d->config.variation.toggle_error ? toggle ^ TOGGLE : toggle;
}

static uint32_t finish_download(drive *const d)
{
    transfer const *const t = &d->sdo.transfer;
    if (t->sized && t->size != t->done) {
        return ABORT_LENGTH;
    }
    return store(d, t->slot, t->data, t->done);
}

static uint32_t take_segment(drive *const d, uint8_t const *const request)
{
    transfer *const t = &d->sdo.transfer;
    uint32_t const bytes = 7U - (request[0] >> 1 & 7U);
    if (t->kind != SDO_DOWNLOAD) {
        return ABORT_COMMAND;
    }
    if ((request[0] & TOGGLE) != t->toggle) {
        return ABORT_TOGGLE;
    }
    if (t->done + bytes > sizeof t->data) {
        return ABORT_TOO_LONG;
    }
    memcpy(&t->data[t->done], &request[1], bytes);
    t->done += bytes;
    return (request[0] & LAST) != 0 ? finish_download(d) : ABORT_NONE;
}

static void download_segment(drive *const d, uint8_t const *const request)
{
    transfer *const t = &d->sdo.transfer;
    uint32_t const code = take_segment(d, request);
    if (code != ABORT_NONE) {
        abort_running(d, code);
        return;
    }
    uint8_t const data[8] = {(uint8_t)(DOWNLOAD | toggle_answered(d, t->toggle))};
    t->toggle ^= TOGGLE;
    t->kind = (request[0] & LAST) != 0 ? SDO_IDLE : SDO_DOWNLOAD;
    answer(d, data);
}

/* The object's value as bytes, as the SDO shows it. */
static uint32_t load(drive *const d, int const slot, uint8_t *const data)
{
    peer_variation const *const v = &d->config.variation;
    object const *const o = &objects[slot];
    if (o->type == STRING) {
        memcpy(data, object_string(slot), object_bytes(slot));
        return object_bytes(slot);
    }
    objects_refresh(d);
    d->toggled = !d->toggled;
    bool const misread = v->misread_index == o->index && v->misread_sub == o->sub;
    put32(data, (uint32_t)d->value[slot] ^ (misread ? v->misread_xor : 0));
    return object_bytes(slot);
}

static void answer_expedited(drive *const d, uint8_t *const data, uint32_t const bytes)
{
    peer_variation const *const v = &d->config.variation;
    bool const padded = v->upload == PEER_UPLOAD_PADDED;
    data[0] = (uint8_t)(0x43U | (padded ? 0 : (4 - bytes) << 2));
    if (v->upload == PEER_UPLOAD_NO_SIZE) {
        data[0] = 0x42;
    }
    memset(&data[4 + bytes], padded ? 0 : (int)v->fill, 4 - bytes);
    memcpy(&data[4], d->sdo.transfer.data, bytes);
    answer(d, data);
}

static void answer_upload(drive *const d, uint8_t const *const request, int const slot)
{
    transfer *const t = &d->sdo.transfer;
    uint32_t const form = d->config.variation.upload;
    uint8_t data[8] = {0, request[1], request[2], request[3]};
    *t = (transfer){.kind = SDO_UPLOAD, .slot = slot};
    t->size = load(d, slot, t->data);
    if (t->size <= 4 && form < PEER_UPLOAD_SEGMENTED) {
        t->kind = SDO_IDLE;
        answer_expedited(d, data, t->size);
        return;
    }
    data[0] = 0x41;
    put32(&data[4], t->size);
    if (form == PEER_UPLOAD_SEGMENTED_NO_SIZE) {
        data[0] = 0x40;
        memset(&data[4], (int)d->config.variation.fill, 4);
    }
    answer(d, data);
}

static void upload(drive *const d, uint8_t const *const request)
{
    int slot = NO_SLOT;
    d->sdo.transfer.kind = SDO_IDLE;
    uint32_t const code = find(d, request, &slot);
    if (code != ABORT_NONE) {
        abort_transfer(d, &request[1], code);
    } else {
        answer_upload(d, request, slot);
    }
}

static void upload_segment(drive *const d, uint8_t const *const request)
{
    transfer *const t = &d->sdo.transfer;
    uint32_t const most = d->config.variation.segment_bytes;
    if (t->kind != SDO_UPLOAD) {
        abort_running(d, ABORT_COMMAND);
        return;
    }
    if ((request[0] & TOGGLE) != t->toggle) {
        abort_running(d, ABORT_TOGGLE);
        return;
    }
    uint32_t bytes = most == 0 ? 7 : most;
    bytes = t->size - t->done < bytes ? t->size - t->done : bytes;
    uint8_t data[8];
    memset(data, (int)d->config.variation.fill, sizeof data);
    data[0] = (uint8_t)(toggle_answered(d, t->toggle) | (7 - bytes) << 1);
    memcpy(&data[1], &t->data[t->done], bytes);
    t->done += bytes;
    t->toggle ^= TOGGLE;
    if (t->done == t->size) {
        data[0] |= LAST;
        t->kind = SDO_IDLE;
    }
    answer(d, data);
}

static void execute(drive *const d, uint8_t const *const request)
{
    switch (request[0] & COMMAND) {
    case DOWNLOAD: download(d, request); break;
    case DOWNLOAD_SEGMENT: download_segment(d, request); break;
    case UPLOAD: upload(d, request); break;
    case UPLOAD_SEGMENT: upload_segment(d, request); break;
    case ABORT: d->sdo.transfer.kind = SDO_IDLE; break;
    default: abort_transfer(d, &request[1], ABORT_COMMAND); break;
    }
}

static void schedule(drive *const d)
{
    d->sdo.serve = NEVER;
    if (d->sdo.waiting > 0) {
        d->sdo.serve = d->peer->now + random_delay(d->peer, d->peer->timing.sdo_delay);
    }
}

void sdo_request(drive *const d, peer_frame const *const frame)
{
    bool const served = d->nmt == PEER_PRE_OPERATIONAL || d->nmt == PEER_OPERATIONAL;
    if (!served || frame->length != 8 || d->sdo.waiting == REQUESTS) {
        return;
    }
    memcpy(d->sdo.request[d->sdo.waiting++], frame->data, 8);
    if (d->sdo.waiting == 1) {
        schedule(d);
    }
}

void sdo_serve(drive *const d)
{
    uint8_t request[8];
    memcpy(request, d->sdo.request[0], 8);
    memmove(d->sdo.request[0], d->sdo.request[1], (size_t)(--d->sdo.waiting) * 8);
    schedule(d);
    execute(d, request);
}

void sdo_reset(drive *const d)
{
    d->sdo.waiting = 0;
    d->sdo.serve = NEVER;
    d->sdo.transfer.kind = SDO_IDLE;
}

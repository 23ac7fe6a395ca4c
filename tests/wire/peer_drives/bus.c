/* The wire of one bus: whose frame goes next, how long it lasts, who gets it (ISO 11898-1). */
#include "peer.h"

enum { ERROR_BITS = 20, BUS_OFF = 256, ERROR_STEP = 8 };

static queued to_send(peer *const p, peer_frame const *const frame, peer_time const ready)
{
    return (queued){*frame, ready, p->order++, frame_arbitration(frame)};
}

static bool fifo_put(fifo *const f, queued const *const item)
{
    if (f->count == QUEUE) {
        return false;
    }
    f->item[(f->first + f->count++) % QUEUE] = *item;
    return true;
}

static queued const *fifo_head(fifo const *const f)
{
    return f->count > 0 ? &f->item[f->first] : NULL;
}

static void fifo_drop(fifo *const f)
{
    f->first = (f->first + 1) % QUEUE;
    f->count--;
}

static bool drive_on_wire(drive const *const d)
{
    return d->on && !d->bus_off && d->nmt != PEER_INITIALISING;
}

static unsigned nodes(peer const *const p, bus const *const b)
{
    unsigned count = adapter_on_wire(b) ? 1 : 0;
    count += b->others.count > 0 ? 1U : 0U;
    for (unsigned i = 0; i < b->drives; i++) {
        count += drive_on_wire(&p->drive[b->drive[i]]) ? 1U : 0U;
    }
    return count;
}

/* The frame a source would send at a time, by its own order; NULL when none is ready then. */
static queued const *offer(peer const *const p, bus const *const b, unsigned const source,
                           peer_time const time)
{
    if (source < FROM_DRIVE) {
        queued const *const head = fifo_head(source == FROM_MASTER ? &b->master : &b->others);
        bool const able = source == FROM_OTHERS || adapter_on_wire(b);
        return head != NULL && able && head->ready <= time ? head : NULL;
    }
    drive const *const d = &p->drive[source - FROM_DRIVE];
    queued const *best = NULL;
    uint64_t lowest = UINT64_MAX;
    for (unsigned i = 0; drive_on_wire(d) && i < d->outgoing; i++) {
        uint64_t const rank = d->out[i].rank;
        bool const better = rank < lowest || (rank == lowest && d->out[i].order < best->order);
        if (d->out[i].ready <= time && better) {
            best = &d->out[i];
            lowest = rank;
        }
    }
    return best;
}

static unsigned source_at(bus const *const b, unsigned const place)
{
    return place < FROM_DRIVE ? place : FROM_DRIVE + b->drive[place - FROM_DRIVE];
}

/* When the first frame of any source is ready. */
static peer_time earliest(peer const *const p, bus const *const b)
{
    peer_time first = NEVER;
    queued const *const head[] = {adapter_on_wire(b) ? fifo_head(&b->master) : NULL,
                                  fifo_head(&b->others)};
    for (unsigned i = 0; i < 2; i++) {
        if (head[i] != NULL && head[i]->ready < first) {
            first = head[i]->ready;
        }
    }
    for (unsigned k = 0; k < b->drives; k++) {
        drive const *const d = &p->drive[b->drive[k]];
        for (unsigned i = 0; drive_on_wire(d) && i < d->outgoing; i++) {
            if (d->out[i].ready < first) {
                first = d->out[i].ready;
            }
        }
    }
    return first;
}

static void remove_sent(peer *const p, bus *const b, unsigned const source,
                        queued const *const item)
{
    if (source < FROM_DRIVE) {
        fifo_drop(source == FROM_MASTER ? &b->master : &b->others);
        return;
    }
    drive *const d = &p->drive[source - FROM_DRIVE];
    size_t const at = (size_t)(item - d->out);
    d->out[at] = d->out[--d->outgoing];
    if (d->errors > 0) {
        d->errors--;
    }
}

static void collide(peer *const p, bus *const b, uint64_t const senders)
{
    b->wire.broken = true;
    b->counters.collisions++;
    for (unsigned i = 0; i < b->drives; i++) {
        drive *const d = &p->drive[b->drive[i]];
        if ((senders >> (FROM_DRIVE + d->number) & 1U) == 0) {
            continue;
        }
        d->errors += ERROR_STEP;
        if (d->errors >= BUS_OFF) {
            d->bus_off = true;
            d->outgoing = 0;
            cia402_connection_lost(d, 0x81FD);
        }
    }
}

static void occupy(peer const *const p, bus *const b, peer_time const start)
{
    wire *const w = &b->wire;
    uint32_t bits = p->timing.worst ? peer_frame_bits_worst(&w->frame) : peer_frame_bits(&w->frame);
    bits += w->broken ? ERROR_BITS : 0;
    w->busy = true;
    w->delivered = false;
    w->arrival = start + bits_time(bits - 3, b->config.bit_rate);
    w->free = start + bits_time(bits, b->config.bit_rate);
    b->counters.busy += w->free - start;
}

/* Arbitration: the lowest of all frames offered; equal identifiers go on together. */
static void begin_frame(peer *const p, bus *const b, peer_time const start)
{
    queued const *offered[FROM_DRIVE + PEER_DRIVES];
    uint64_t lowest = UINT64_MAX;
    queued const *winner = NULL;
    for (unsigned i = 0; i < FROM_DRIVE + b->drives; i++) {
        offered[i] = offer(p, b, source_at(b, i), start);
        if (offered[i] != NULL && offered[i]->rank < lowest) {
            lowest = offered[i]->rank;
            winner = offered[i];
        }
    }
    b->wire = (wire){.frame = winner->frame};
    bool unequal = false;
    for (unsigned i = 0; i < FROM_DRIVE + b->drives; i++) {
        if (offered[i] != NULL && offered[i]->rank == lowest) {
            b->wire.senders |= 1ULL << source_at(b, i);
            unequal = unequal || !frame_equal(&offered[i]->frame, &b->wire.frame);
        }
    }
    for (unsigned i = 0; !unequal && i < FROM_DRIVE + b->drives; i++) {
        if ((b->wire.senders >> source_at(b, i) & 1U) != 0) {
            remove_sent(p, b, source_at(b, i), offered[i]);
        }
    }
    if (unequal) {
        collide(p, b, b->wire.senders);
    }
    occupy(p, b, start);
}

void bus_put_inbox(peer *const p, bus *const b, peer_frame const *const frame)
{
    if (b->config.adapter) {
        adapter_frame(p, b, frame);
    } else if (b->count < INBOX) {
        b->inbox[(b->first + b->count++) % INBOX] = (queued){.frame = *frame, .ready = p->now};
    } else {
        b->counters.overflows++;
    }
}

static void drive_receive(drive *const d, peer_frame const *const frame)
{
    uint32_t const node = d->config.node;
    if (frame->extended || frame->remote) {
        return;
    }
    if (frame->id == 0x000) {
        nmt_command(d, frame);
    } else if (frame->id == 0x080) {
        pdo_sync(d);
    } else if (frame->id == 0x600 + node) {
        sdo_request(d, frame);
    } else if (frame->id > 0x700 && frame->id < 0x780) {
        nmt_heartbeat_heard(d, frame->id - 0x700);
    } else {
        pdo_receive(d, frame);
    }
}

static void deliver(peer *const p, bus *const b)
{
    wire *const w = &b->wire;
    w->delivered = true;
    if (w->broken) {
        return;
    }
    b->counters.frames++;
    bool const own = (w->senders >> FROM_MASTER & 1U) != 0;
    bool const echoed = (b->config.variation.echo_sync && w->frame.id == 0x080) ||
                        (b->config.variation.echo_frames && b->config.adapter);
    if (adapter_on_wire(b) && (!own || echoed)) {
        bus_put_inbox(p, b, &w->frame);
    }
    for (unsigned i = 0; i < b->drives; i++) {
        drive *const d = &p->drive[b->drive[i]];
        if (drive_on_wire(d) && (w->senders >> (FROM_DRIVE + d->number) & 1U) == 0) {
            drive_receive(d, &w->frame);
        }
    }
}

peer_time bus_next(peer const *const p, bus const *const b)
{
    peer_time next = b->next_time < b->next_foreign ? b->next_time : b->next_foreign;
    peer_time frame = NEVER;
    if (b->wire.busy) {
        frame = b->wire.delivered ? b->wire.free : b->wire.arrival;
    } else {
        frame = earliest(p, b);
        if (frame != NEVER && nodes(p, b) < 2) {
            frame = NEVER; /* nobody there to acknowledge */
        }
        if (frame < p->now) {
            frame = p->now;
        }
    }
    return frame < next ? frame : next;
}

static void put_other(peer *const p, bus *const b, peer_frame const *const frame)
{
    queued const item = to_send(p, frame, p->now);
    if (!fifo_put(&b->others, &item)) {
        b->counters.overflows++;
    }
}

static void foreign_nodes(peer *const p, bus *const b)
{
    peer_bus_variation const *const v = &b->config.variation;
    if (p->now >= b->next_time) {
        peer_frame const frame = {.id = 0x100, .length = 6, .data = {0x10, 0x20, 0x30, 0, 0x40, 0}};
        put_other(p, b, &frame);
        b->next_time += v->time_period;
    }
    if (p->now >= b->next_foreign) {
        peer_frame const frame = {
            .id = 0x700 + v->foreign_node, .length = 1, .data = {(uint8_t)v->foreign_state}};
        put_other(p, b, &frame);
        b->next_foreign += v->foreign_period;
    }
}

void bus_step(peer *const p, bus *const b)
{
    foreign_nodes(p, b);
    if (b->wire.busy && !b->wire.delivered && p->now >= b->wire.arrival) {
        deliver(p, b);
    } else if (b->wire.busy && b->wire.delivered && p->now >= b->wire.free) {
        b->wire.busy = false;
    } else if (!b->wire.busy && nodes(p, b) >= 2 && earliest(p, b) <= p->now) {
        begin_frame(p, b, p->now);
    }
}

void drive_transmit(drive *const d, uint32_t const id, uint8_t const *const data,
                    uint8_t const length, peer_time const ready)
{
    if (d->outgoing == OUTGOING || d->bus_off) {
        d->counters.dropped++;
        return;
    }
    peer_frame frame = {.id = id, .length = length};
    memcpy(frame.data, data, length);
    d->out[d->outgoing++] = to_send(d->peer, &frame, ready);
}

static bool queue_frame(peer *const p, fifo *const f, peer_time const time,
                        peer_frame const *const frame)
{
    if (!frame_valid(frame)) {
        return false;
    }
    queued const item = to_send(p, frame, time > p->now ? time : p->now);
    return fifo_put(f, &item);
}

bool peer_send(peer *const p, uint32_t const number, peer_time const time,
               peer_frame const *const frame)
{
    return queue_frame(p, &p->bus[number].master, time, frame);
}

bool peer_inject(peer *const p, uint32_t const number, peer_time const time,
                 peer_frame const *const frame)
{
    return queue_frame(p, &p->bus[number].others, time, frame);
}

bool peer_receive(peer *const p, uint32_t const number, peer_frame *const frame,
                  peer_time *const time)
{
    bus *const b = &p->bus[number];
    if (b->count == 0) {
        return false;
    }
    *frame = b->inbox[b->first].frame;
    *time = b->inbox[b->first].ready;
    b->first = (b->first + 1) % INBOX;
    b->count--;
    return true;
}

size_t peer_waiting(peer const *const p, uint32_t const number)
{
    return p->bus[number].master.count;
}

peer_bus_counters peer_bus_counted(peer const *const p, uint32_t const number)
{
    return p->bus[number].counters;
}

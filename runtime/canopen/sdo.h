/* Service data: a client that reads and writes the objects of one drive (CiA 301, 7.2.4.3).
 *
 * One transfer at a time, one frame a call: tb_sdo_frame gives the next request whenever there is
 * one to send, tb_sdo_take reads an answer, tb_sdo_tick counts the cycles. Up to four bytes travel
 * in one frame (expedited), more in segments of seven. A server that answers wrongly or not at all
 * is sent an abort. */
#ifndef TB_SDO_H
#define TB_SDO_H

#include <stdbool.h>
#include <stdint.h>

#include "can.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Abort codes that this client sends */
#define TB_SDO_ABORT_TOGGLE 0x05030000u
#define TB_SDO_ABORT_TIMEOUT 0x05040000u
#define TB_SDO_ABORT_COMMAND 0x05040001u
#define TB_SDO_ABORT_MEMORY 0x05040005u
#define TB_SDO_ABORT_LENGTH 0x06070010u
#define TB_SDO_ABORT_GENERAL 0x08000000u

/** How far a transfer is. */
typedef enum {
    TB_SDO_IDLE = 0,
    TB_SDO_BUSY,
    TB_SDO_DONE,
    TB_SDO_REFUSED, /* the server aborted: `code` */
    TB_SDO_BROKEN,  /* the server misbehaved and was sent an abort: `code` */
    TB_SDO_SILENT   /* the server did not answer in time */
} tb_sdo_result;

/** One client and what it transfers. */
typedef struct {
    const uint8_t *source; /* of a download */
    uint8_t *target;       /* of an upload */
    uint32_t room;         /* bytes in target */
    uint32_t size;         /* bytes of the object; of an upload once the server said so */
    uint32_t done;         /* bytes transferred */
    uint32_t code;         /* abort code */
    uint32_t waited;       /* cycles since the request was ready */
    uint32_t timeout;      /* cycles until an unanswered request has failed */
    uint16_t index;
    uint8_t subindex;
    uint8_t node;
    uint8_t result;    /* tb_sdo_result */
    uint8_t step;      /* which request or answer is next: sdo.c */
    uint8_t toggle;    /* of the next segment: 0x00 or 0x10 */
    uint8_t sized;     /* 1: the server said how long the object is; else the bytes beyond what
                            the object has are undefined */
    uint8_t to_send;   /* 1: a request is ready; 0: an answer is awaited */
    uint8_t aborting;  /* 1: an abort is to be sent */
    uint8_t owed;      /* answers to requests that were given up, which may still come */
    uint8_t extra;     /* answers that nobody asked for: two drives answer; stops at 255 */
    uint8_t answer[4]; /* command and object of the last answer that was taken */
} tb_sdo_client;

/** A client without a transfer. timeout [cycles]: until an unanswered request has failed. */
void tb_sdo_start(tb_sdo_client *client, uint8_t node, uint32_t timeout);

/** Begin to write an object. The data must stay until the transfer has ended. */
void tb_sdo_download(tb_sdo_client *client, uint16_t index, uint8_t subindex, const uint8_t data[],
                     uint32_t size);

/** Begin to read an object of at most `room` bytes; `done` tells how many there were. */
void tb_sdo_upload(tb_sdo_client *client, uint16_t index, uint8_t subindex, uint8_t data[],
                   uint32_t room);

/** Give the transfer up, if there is one. */
void tb_sdo_cancel(tb_sdo_client *client);

/** Next frame to send. False: there is none. */
bool tb_sdo_frame(tb_sdo_client *client, tb_can_frame *frame);

/** Read an answer. False: malformed, and ignored. */
bool tb_sdo_take(tb_sdo_client *client, const tb_can_frame *frame);

/** A cycle has passed. */
void tb_sdo_tick(tb_sdo_client *client);

/** An abort code of CiA 301 in words. */
const char *tb_sdo_abort_text(uint32_t code);

#ifdef __cplusplus
}
#endif

#endif

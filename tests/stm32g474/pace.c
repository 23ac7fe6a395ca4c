/** What happens at every instruction and every polling read, where Python would be too slow.
 *
 *  Instructions are counted, reads of registers that cannot have changed are answered, and free
 *  running counters follow the count. All else is asked of and told to the Python model. */
#include <stdbool.h>
#include <stdint.h>

enum {
    BUS_WAIT = 3, /**< what an access to a peripheral costs beyond its instruction [instructions] */
    KNOWN = 1,    /**< the kind of a register whose value stays until it is forgotten */
    COUNTERS = 2  /**< kinds from here on are a counter's number plus this */
};

/** A register that counts with the clock of the processor. */
typedef struct {
    uint64_t since;       /**< the count of instructions when it stood at `origin` */
    uint64_t origin;      /**< counts */
    uint64_t numerator;   /**< counts by instruction, as a fraction */
    uint64_t denominator; /**< never zero */
    uint64_t period;      /**< the counter returns to zero here */
    uint64_t top;         /**< what is read is this less the count when it counts down, else zero */
} pace_counter;

typedef struct {
    uint64_t count; /**< instructions so far, waiting for the bus included */
    uint64_t limit; /**< execution stops at the first block from here on */
    uint64_t place; /**< address of the latest instruction */
    uint64_t wrong; /**< address of an instruction that this processor refuses, or zero */
    uint64_t reason;
    uint64_t floating; /**< whether the floating-point unit is enabled */
    uint64_t dividing; /**< whether a division by zero is refused */
    uint64_t aligning; /**< whether every unaligned access is refused */
    uint64_t address;  /**< of the data of a refused instruction */
    uint64_t feeding;  /**< address of a register that is fed with `food`, or zero */
    uint64_t food;
    uint64_t fed;    /**< the count when that was done last */
    uint64_t guards; /**< how many ranges are denied */
    struct {
        uint64_t begin, end; /**< no data is read or written from here to before there */
    } denied[8];
    int (*read_register)(void *emulator, int number, void *value);
    int (*stop)(void *emulator);
    int (*fetch)(void *emulator, uint64_t address, void *bytes, uint64_t size);
    uint64_t (*ask)(uint64_t address, uint32_t size);
    void (*tell)(uint64_t address, uint32_t size, uint64_t value);
    pace_counter counters[16];
} pace;

typedef struct {
    pace *pace;
    uint64_t base;
    uint8_t *kinds;   /**< one for each word */
    uint32_t *values; /**< one for each word */
} pace_window;

enum { NO_COPROCESSOR = 1, UNALIGNED = 2, DIVISION = 3, DENIED = 4 };

/** Unicorn's number of r0; those up to r12 follow. */
enum { FIRST_REGISTER = 66 };

static void refuse(void *const emulator, pace *const p, uint64_t const reason)
{
    if (p->wrong == 0) {
        p->wrong = p->place;
        p->reason = reason;
    }
    p->limit = 0;
    p->stop(emulator);
}

static uint32_t instruction_at(void *const emulator, pace const *const p, uint64_t const address)
{
    uint16_t halves[2] = {0, 0};
    p->fetch(emulator, address, halves, sizeof halves);
    return (uint32_t)halves[0] << 16 | halves[1];
}

/** VFP and NEON encodings: coprocessors 10 and 11. */
static bool is_floating(uint32_t const instruction)
{
    uint32_t const coprocessor = instruction >> 8 & 0xEU;
    return (instruction & 0xEC000000U) == 0xEC000000U && coprocessor == 0xAU;
}

/** Loads and stores of several words, which never may be unaligned: LDM, STM, LDRD, STRD, the
 *  exclusive ones, VLDR, VSTR, PUSH and POP. */
static bool needs_words(uint32_t const instruction)
{
    uint32_t const half = instruction >> 16;
    bool const several = (half & 0xFE00U) == 0xE800U;
    bool const narrow_several = (half & 0xF000U) == 0xC000U || (half & 0xF600U) == 0xB400U;
    bool const floating = (half & 0xEE00U) == 0xEC00U;
    return several || narrow_several || floating;
}

/** UDIV or SDIV by a register that is zero. */
static bool divides_by_zero(void *const emulator, pace const *const p, uint32_t const instruction)
{
    uint32_t divisor = 1;
    if ((instruction & 0xFFD0F0F0U) == 0xFB90F0F0U) {
        p->read_register(emulator, FIRST_REGISTER + (int)(instruction & 0xFU), &divisor);
    }
    return divisor == 0;
}

static bool is_denied(pace const *const p, uint64_t const address)
{
    for (uint64_t i = 0; i < p->guards; i++) {
        if (address >= p->denied[i].begin && address < p->denied[i].end) {
            return true;
        }
    }
    return false;
}

void pace_instruction(void *emulator, uint64_t address, uint32_t size, void *user)
{
    pace *const p = user;
    p->count++;
    p->place = address;
    if (p->floating == 0 && is_floating(instruction_at(emulator, p, address))) {
        refuse(emulator, p, NO_COPROCESSOR);
    } else if (p->dividing != 0 && size == 4 &&
               divides_by_zero(emulator, p, instruction_at(emulator, p, address))) {
        refuse(emulator, p, DIVISION);
    }
}

void pace_block(void *emulator, uint64_t address, uint32_t size, void *user)
{
    pace const *const p = user;
    (void)address;
    (void)size;
    if (p->count >= p->limit) {
        p->stop(emulator);
    }
}

/** At every access to memory, when that is asked for. */
void pace_memory(void *emulator, int type, uint64_t address, int size, int64_t value, void *user)
{
    pace *const p = user;
    (void)type;
    (void)value;
    bool const unaligned = (address & ((uint64_t)size - 1U)) != 0;
    if (unaligned &&
        (p->aligning != 0 || (size >= 4 && needs_words(instruction_at(emulator, p, p->place))))) {
        p->address = address;
        refuse(emulator, p, UNALIGNED);
    } else if (p->guards != 0 && is_denied(p, address)) {
        p->address = address;
        refuse(emulator, p, DENIED);
    }
}

static uint64_t counted(pace const *const p, pace_counter const *const c)
{
    uint64_t const passed = (p->count - c->since) * c->numerator / c->denominator;
    uint64_t const value = (c->origin + passed) % c->period;
    return c->top != 0 ? c->top - value : value;
}

/** What a counter shows now. */
uint64_t pace_counted(pace const *p, unsigned number)
{
    return counted(p, &p->counters[number]);
}

uint64_t pace_read(void *emulator, uint64_t offset, unsigned size, void *user)
{
    pace_window const *const w = user;
    pace *const p = w->pace;
    uint8_t const kind = w->kinds[offset >> 2];
    (void)emulator;
    p->count += BUS_WAIT;
    if (kind == 0 || size != 4 || (offset & 3U) != 0) {
        return p->ask(w->base + offset, size);
    }
    return kind == KNOWN ? w->values[offset >> 2] : counted(p, &p->counters[kind - COUNTERS]);
}

void pace_write(void *emulator, uint64_t offset, unsigned size, uint64_t value, void *user)
{
    pace_window const *const w = user;
    pace *const p = w->pace;
    uint64_t const address = w->base + offset;
    (void)emulator;
    p->count += BUS_WAIT;
    if (address == p->feeding && value == p->food && size == 4) {
        p->fed = p->count;
    } else {
        p->tell(address, size, value);
    }
}

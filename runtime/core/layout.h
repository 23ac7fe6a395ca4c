/* The layout of C structs and the values of enumerations as data, so that a program of another
 * language reads what this one writes by the names of its members.
 *
 * A description is a list of rows. The row of a struct is followed by those of its members, the row
 * of an enumeration by those of its values; a struct stands before the structs that contain it.
 * Place, size and kind come from the compiler (offsetof, sizeof, _Generic): a row cannot disagree
 * with the C. codegen/struct_layout.py is a reader. */
#ifndef TB_LAYOUT_H
#define TB_LAYOUT_H

#include <stddef.h>
#include <stdint.h>

/** A row of a description. */
typedef struct {
    char name[28];  /* of a struct, a member, an enumeration or a value; without TB_ */
    char type[20];  /* of a member that is a struct: the name of that struct */
    uint32_t kind;  /* TB_LAYOUT_IS_... */
    uint32_t at;    /* member: bytes from the beginning of its struct; value: the value */
    uint32_t size;  /* struct, member: bytes, of a member that is an array those of one entry */
    uint32_t count; /* member that is an array: entries; else 0 */
} tb_layout_row;

#define TB_LAYOUT_IS_STRUCT ((uint32_t)'s')
#define TB_LAYOUT_IS_PART ((uint32_t)'p') /* a member that is a struct */
#define TB_LAYOUT_IS_REAL ((uint32_t)'f')
#define TB_LAYOUT_IS_UNSIGNED ((uint32_t)'u')
#define TB_LAYOUT_IS_SIGNED ((uint32_t)'i')
#define TB_LAYOUT_IS_TEXT ((uint32_t)'S') /* filled up with 0 */
#define TB_LAYOUT_IS_ENUMERATION ((uint32_t)'e')
#define TB_LAYOUT_IS_VALUE ((uint32_t)'v')

/** Kind of a number; any other type is an error of compilation. */
#define TB_LAYOUT_KIND(number)                                                                     \
    _Generic((number), float                                                                       \
             : TB_LAYOUT_IS_REAL, double                                                           \
             : TB_LAYOUT_IS_REAL, uint8_t                                                          \
             : TB_LAYOUT_IS_UNSIGNED, uint16_t                                                     \
             : TB_LAYOUT_IS_UNSIGNED, uint32_t                                                     \
             : TB_LAYOUT_IS_UNSIGNED, uint64_t                                                     \
             : TB_LAYOUT_IS_UNSIGNED, int32_t                                                      \
             : TB_LAYOUT_IS_SIGNED, int64_t                                                        \
             : TB_LAYOUT_IS_SIGNED)

/* A member of tb_STRUCT, of no particular one. */
#define TB_LAYOUT_MEMBER(of, member) (((tb_##of *)0)->member)
#define TB_LAYOUT_ROW(of, member, type, kind, entry, count)                                        \
    {#member,          type, kind, (uint32_t)offsetof(tb_##of, member), (uint32_t)sizeof(entry),   \
     (uint32_t)(count)},
#define TB_LAYOUT_LENGTH(of, member)                                                               \
    (sizeof(TB_LAYOUT_MEMBER(of, member)) / sizeof(TB_LAYOUT_MEMBER(of, member)[0]))

/** A struct tb_NAME; the rows of its members follow. */
#define TB_LAYOUT_STRUCT(name) {#name, "", TB_LAYOUT_IS_STRUCT, 0, (uint32_t)sizeof(tb_##name), 0},

/** A member of the struct tb_OF that is a number. */
#define TB_LAYOUT_NUMBER(of, member)                                                               \
    TB_LAYOUT_ROW(of, member, "", TB_LAYOUT_KIND(TB_LAYOUT_MEMBER(of, member)),                    \
                  TB_LAYOUT_MEMBER(of, member), 0)

/** A member that is an array of numbers. */
#define TB_LAYOUT_NUMBERS(of, member)                                                              \
    TB_LAYOUT_ROW(of, member, "", TB_LAYOUT_KIND(TB_LAYOUT_MEMBER(of, member)[0]),                 \
                  TB_LAYOUT_MEMBER(of, member)[0], TB_LAYOUT_LENGTH(of, member))

/** A member that is a text. */
#define TB_LAYOUT_TEXT(of, member)                                                                 \
    TB_LAYOUT_ROW(of, member, "",                                                                  \
                  _Generic(TB_LAYOUT_MEMBER(of, member)[0], char                                   \
                           : TB_LAYOUT_IS_TEXT),                                                   \
                  TB_LAYOUT_MEMBER(of, member), 0)

/** A member that is an array of texts. */
#define TB_LAYOUT_TEXTS(of, member)                                                                \
    TB_LAYOUT_ROW(of, member, "",                                                                  \
                  _Generic(TB_LAYOUT_MEMBER(of, member)[0][0], char                                \
                           : TB_LAYOUT_IS_TEXT),                                                   \
                  TB_LAYOUT_MEMBER(of, member)[0], TB_LAYOUT_LENGTH(of, member))

/** A member that is a struct tb_TYPE. */
#define TB_LAYOUT_PART(of, member, type)                                                           \
    TB_LAYOUT_ROW(of, member, #type,                                                               \
                  _Generic(TB_LAYOUT_MEMBER(of, member), tb_##type                                 \
                           : TB_LAYOUT_IS_PART),                                                   \
                  TB_LAYOUT_MEMBER(of, member), 0)

/** A member that is an array of structs tb_TYPE. */
#define TB_LAYOUT_PARTS(of, member, type)                                                          \
    TB_LAYOUT_ROW(of, member, #type,                                                               \
                  _Generic(TB_LAYOUT_MEMBER(of, member)[0], tb_##type                              \
                           : TB_LAYOUT_IS_PART),                                                   \
                  TB_LAYOUT_MEMBER(of, member)[0], TB_LAYOUT_LENGTH(of, member))

/** An enumeration; the rows of its values follow. */
#define TB_LAYOUT_ENUMERATION(name) {#name, "", TB_LAYOUT_IS_ENUMERATION, 0, 0, 0},

/** The value TB_NAME. */
#define TB_LAYOUT_VALUE(name) {#name, "", TB_LAYOUT_IS_VALUE, (uint32_t)TB_##name, 0, 0},

#endif

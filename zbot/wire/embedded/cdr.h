#ifndef ZBOT_CDR_H
#define ZBOT_CDR_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Items of a sequence without a bound, e.g. float32[]. */
#ifndef ZBOT_CDR_CAPACITY
#define ZBOT_CDR_CAPACITY 16
#endif

/* Bytes of a text without a bound, without the NUL at its end. */
#ifndef ZBOT_CDR_TEXT_CAPACITY
#define ZBOT_CDR_TEXT_CAPACITY 63
#endif

/* Result of the functions __write and __read. */
typedef enum {
    ZBOT_CDR_OK = 0,
    ZBOT_CDR_NO_MEMORY = -1, /* the message needs more bytes than the buffer has */
    ZBOT_CDR_TRUNCATED = -2, /* the bytes end before the message does */
    ZBOT_CDR_TOO_LONG = -3,  /* a text or a sequence is longer than its capacity */
    ZBOT_CDR_INVALID = -4    /* the bytes are not CDR, or a wide text is not UTF-16 */
} zbot_cdr_status;

#define ZBOT_CDR_HEADER_SIZE 4

/* CDR contains a float64 as 8 bytes. A compiler whose double is shorter ends here with an error. */
typedef char zbot_cdr_double_must_have_8_bytes[sizeof(double) == 8 ? 1 : -1];

/* Writer of bytes. After the first error, it writes nothing more. */
typedef struct {
    uint8_t *data; /* the bytes after the header; positions are counted from here */
    size_t size;
    size_t position;
    zbot_cdr_status status;
} zbot_cdr_writer;

/* Reader of bytes. After the first error, all values are zero. */
typedef struct {
    const uint8_t *data;
    size_t size;
    size_t position;
    zbot_cdr_status status;
    bool is_big_endian;
} zbot_cdr_reader;

static inline zbot_cdr_writer zbot_cdr_begin_write(uint8_t *data, size_t size)
{
    static const uint8_t header[ZBOT_CDR_HEADER_SIZE] = {0, 1, 0, 0}; /* little-endian */
    zbot_cdr_writer cdr = {NULL, 0, 0, ZBOT_CDR_NO_MEMORY};
    if (size >= ZBOT_CDR_HEADER_SIZE) {
        memcpy(data, header, ZBOT_CDR_HEADER_SIZE);
        cdr.data = data + ZBOT_CDR_HEADER_SIZE;
        cdr.size = size - ZBOT_CDR_HEADER_SIZE;
        cdr.status = ZBOT_CDR_OK;
    }
    return cdr;
}

static inline zbot_cdr_status zbot_cdr_end_write(const zbot_cdr_writer *cdr, size_t *length)
{
    *length = cdr->status == ZBOT_CDR_OK ? ZBOT_CDR_HEADER_SIZE + cdr->position : 0;
    return cdr->status;
}

/* Returns where the next bytes go, or NULL after an error. */
static inline uint8_t *zbot_cdr_room(zbot_cdr_writer *cdr, size_t alignment, size_t size)
{
    size_t padding = (alignment - cdr->position % alignment) % alignment;
    size_t left = cdr->size - cdr->position;
    uint8_t *room;
    if (cdr->status != ZBOT_CDR_OK) {
        return NULL;
    }
    if (left < padding || left - padding < size) {
        cdr->status = ZBOT_CDR_NO_MEMORY;
        return NULL;
    }
    room = cdr->data + cdr->position;
    memset(room, 0, padding);
    cdr->position += padding + size;
    return room + padding;
}

/* Writes an integer. Its size is 1, 2, 4 or 8 bytes. */
static inline void zbot_cdr_put(zbot_cdr_writer *cdr, uint64_t value, size_t size)
{
    uint8_t *room = zbot_cdr_room(cdr, size, size);
    for (size_t i = 0; room != NULL && i < size; i++) {
        room[i] = (uint8_t)(value >> (8 * i));
    }
}

static inline void zbot_cdr_put_float(zbot_cdr_writer *cdr, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    zbot_cdr_put(cdr, bits, sizeof bits);
}

static inline void zbot_cdr_put_double(zbot_cdr_writer *cdr, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    zbot_cdr_put(cdr, bits, sizeof bits);
}

static inline void zbot_cdr_put_bytes(zbot_cdr_writer *cdr, const void *bytes, size_t count)
{
    uint8_t *room = zbot_cdr_room(cdr, 1, count);
    if (room != NULL && count > 0) {
        memcpy(room, bytes, count);
    }
}

/* Writes the number of items. Returns how many items to write: none after an error. */
static inline uint32_t zbot_cdr_put_count(zbot_cdr_writer *cdr, uint32_t count, uint32_t capacity)
{
    if (cdr->status == ZBOT_CDR_OK && count > capacity) {
        cdr->status = ZBOT_CDR_TOO_LONG;
    }
    zbot_cdr_put(cdr, count, 4);
    return cdr->status == ZBOT_CDR_OK ? count : 0;
}

/* Writes a text. Only the NUL at its end may be the byte after its capacity. */
static inline void zbot_cdr_put_text(zbot_cdr_writer *cdr, const char *text, uint32_t capacity)
{
    const char *end = (const char *)memchr(text, 0, (size_t)capacity + 1);
    uint32_t length = end == NULL ? 0 : (uint32_t)(end - text) + 1;
    if (cdr->status == ZBOT_CDR_OK && end == NULL) {
        cdr->status = ZBOT_CDR_TOO_LONG;
    }
    zbot_cdr_put(cdr, length, 4);
    zbot_cdr_put_bytes(cdr, text, length);
}

/* Writes a wide text. ROS 2 sends each unit of UTF-16 as four bytes. */
static inline void zbot_cdr_put_wide_text(zbot_cdr_writer *cdr, const uint16_t *units,
                                          uint32_t count, uint32_t capacity)
{
    count = zbot_cdr_put_count(cdr, count, capacity);
    for (uint32_t i = 0; i < count; i++) {
        zbot_cdr_put(cdr, units[i], 4);
    }
}

static inline zbot_cdr_reader zbot_cdr_begin_read(const uint8_t *data, size_t length)
{
    zbot_cdr_reader cdr = {NULL, 0, 0, ZBOT_CDR_TRUNCATED, false};
    if (length >= ZBOT_CDR_HEADER_SIZE) {
        cdr.data = data + ZBOT_CDR_HEADER_SIZE;
        cdr.size = length - ZBOT_CDR_HEADER_SIZE;
        cdr.status = data[0] == 0 && data[1] <= 1 ? ZBOT_CDR_OK : ZBOT_CDR_INVALID;
        cdr.is_big_endian = data[1] == 0;
    }
    return cdr;
}

/* Returns where the next bytes are, or NULL after an error. */
static inline const uint8_t *zbot_cdr_next(zbot_cdr_reader *cdr, size_t alignment, size_t size)
{
    size_t padding = (alignment - cdr->position % alignment) % alignment;
    size_t left = cdr->size - cdr->position;
    const uint8_t *next;
    if (cdr->status != ZBOT_CDR_OK) {
        return NULL;
    }
    if (left < padding || left - padding < size) {
        cdr->status = ZBOT_CDR_TRUNCATED;
        return NULL;
    }
    next = cdr->data + cdr->position + padding;
    cdr->position += padding + size;
    return next;
}

/* Reads an integer. Its size is 1, 2, 4 or 8 bytes. */
static inline uint64_t zbot_cdr_get(zbot_cdr_reader *cdr, size_t size)
{
    const uint8_t *next = zbot_cdr_next(cdr, size, size);
    uint64_t value = 0;
    for (size_t i = 0; next != NULL && i < size; i++) {
        value |= (uint64_t)next[i] << (8 * (cdr->is_big_endian ? size - 1 - i : i));
    }
    return value;
}

static inline float zbot_cdr_get_float(zbot_cdr_reader *cdr)
{
    uint32_t bits = (uint32_t)zbot_cdr_get(cdr, sizeof bits);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static inline double zbot_cdr_get_double(zbot_cdr_reader *cdr)
{
    uint64_t bits = zbot_cdr_get(cdr, sizeof bits);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static inline void zbot_cdr_get_bytes(zbot_cdr_reader *cdr, void *bytes, size_t count)
{
    const uint8_t *next = zbot_cdr_next(cdr, 1, count);
    if (next != NULL && count > 0) {
        memcpy(bytes, next, count);
    }
}

/* Reads the number of items. Returns how many items to read: none after an error. */
static inline uint32_t zbot_cdr_get_count(zbot_cdr_reader *cdr, uint32_t capacity)
{
    uint32_t count = (uint32_t)zbot_cdr_get(cdr, 4);
    if (cdr->status == ZBOT_CDR_OK && count > capacity) {
        cdr->status = ZBOT_CDR_TOO_LONG;
    }
    return cdr->status == ZBOT_CDR_OK ? count : 0;
}

/* Reads a text. The memory at `text` has one byte more than the capacity. */
static inline void zbot_cdr_get_text(zbot_cdr_reader *cdr, char *text, uint32_t capacity)
{
    uint32_t length = (uint32_t)zbot_cdr_get(cdr, 4);
    const char *next = (const char *)zbot_cdr_next(cdr, 1, length);
    text[0] = 0;
    if (next == NULL || length == 0) {
        return;
    }
    if (next[length - 1] == 0) {
        length--; /* the NUL at the end is not a part of the text */
    }
    if (length > capacity) {
        cdr->status = ZBOT_CDR_TOO_LONG;
        return;
    }
    memcpy(text, next, length);
    text[length] = 0;
}

/* Reads a wide text. Returns the number of its units. */
static inline uint32_t zbot_cdr_get_wide_text(zbot_cdr_reader *cdr, uint16_t *units,
                                              uint32_t capacity)
{
    uint32_t count = zbot_cdr_get_count(cdr, capacity);
    for (uint32_t i = 0; i < count; i++) {
        uint64_t unit = zbot_cdr_get(cdr, 4);
        if (unit > 0xFFFF) {
            cdr->status = ZBOT_CDR_INVALID;
        }
        units[i] = (uint16_t)unit;
    }
    return cdr->status == ZBOT_CDR_OK ? count : 0;
}

#endif /* ZBOT_CDR_H */

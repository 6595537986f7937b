/* Compares the functions of a generated header with the bytes of zbot. The test writes types.inc. */

#include "messages.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct {
    const char *name;
    size_t size;     /* of the struct */
    size_t max_size; /* of the bytes */
    void (*init)(void *message);
    void (*fill)(void *message);
    zbot_cdr_status (*write)(const void *message, uint8_t *data, size_t size, size_t *length);
    zbot_cdr_status (*read)(void *message, const uint8_t *data, size_t length);
} type;

#define TYPE(T)                                                                                \
    static void T##_i(void *message) { T##__init((T *)message); }                              \
    static zbot_cdr_status T##_w(const void *message, uint8_t *data, size_t size, size_t *used) \
    {                                                                                          \
        return T##__write((const T *)message, data, size, used);                               \
    }                                                                                          \
    static zbot_cdr_status T##_r(void *message, const uint8_t *data, size_t length)            \
    {                                                                                          \
        return T##__read((T *)message, data, length);                                          \
    }
#define ENTRY(T) {T##__TYPE_NAME, sizeof(T), T##__MAX_SIZE, T##_i, T##_f, T##_w, T##_r},

#include "types.inc"

enum { ROOM = 1 << 16, CANARY = 0xA5 };
static uint8_t expected[ROOM], found[ROOM], small[ROOM];

static size_t next_expected(FILE *file)
{
    uint8_t count[4] = {0, 0, 0, 0};
    size_t length;
    if (fread(count, 1, 4, file) != 4) {
        return 0;
    }
    length = count[0] | (size_t)count[1] << 8 | (size_t)count[2] << 16;
    return fread(expected, 1, length, file);
}

static void check(int is_right, const type *one, const char *what)
{
    if (!is_right) {
        printf("%s: %s\n", one->name, what);
    }
}

/* A buffer that is too small is an error, and no byte after the buffer changes. */
static void check_small_buffers(const type *one, const void *message, size_t length)
{
    for (size_t size = 0; size < length; size++) {
        size_t used = 1;
        memset(small, CANARY, length);
        check(one->write(message, small, size, &used) == ZBOT_CDR_NO_MEMORY, one, "no memory");
        check(used == 0 && small[size] == CANARY, one, "bytes after the buffer");
    }
}

static void check_cut_bytes(const type *one, void *message, size_t length)
{
    for (size_t size = 0; size < length; size++) {
        uint8_t *exact = (uint8_t *)malloc(size + 1);
        memcpy(exact, expected, size);
        check(one->read(message, exact, size) == ZBOT_CDR_TRUNCATED, one, "truncated");
        free(exact);
    }
}

static void check_type(const type *one, FILE *file)
{
    void *message = calloc(1, one->size), *other = calloc(1, one->size);
    size_t used = 0, length = next_expected(file);
    one->fill(message);
    check(one->write(message, found, ROOM, &used) == ZBOT_CDR_OK, one, "write");
    check(used == length && memcmp(found, expected, length) == 0, one, "written bytes");
    check(length <= one->max_size, one, "largest size");
    check(one->read(other, expected, length) == ZBOT_CDR_OK, one, "read");
    check(memcmp(message, other, one->size) == 0, one, "fields");
    check_small_buffers(one, message, length);
    check_cut_bytes(one, other, length);
    length = next_expected(file);
    one->init(message);
    check(one->write(message, found, ROOM, &used) == ZBOT_CDR_OK, one, "write of defaults");
    check(used == length && memcmp(found, expected, length) == 0, one, "default values");
    free(message);
    free(other);
}

int main(int count, char **words)
{
    FILE *file = count == 2 ? fopen(words[1], "rb") : NULL;
    size_t number = sizeof types / sizeof types[0];
    if (file == NULL) {
        return 1;
    }
    for (size_t i = 0; i < number; i++) {
        check_type(&types[i], file);
    }
    fclose(file);
    printf("%d types\n", (int)number);
    return 0;
}

/* replay LINE: touches each stream of replay.h in a buffer of its own, which nothing else touches; LINE bytes are a line of
 * the cache. It is built without sanitizers, which do not run under valgrind. */
#include "../replay.h"
#include <stddef.h>
#include <stdlib.h>

enum { MEGABYTE = 1 << 20 };

/* The read has a line of the source to itself: a function's return reads memory as well. */
static inline __attribute__((always_inline)) void touch(const volatile char *buffer, int kind, size_t line)
{
    for (uint32_t i = 0; i < REPLAY_ACCESSES; i++) {
        const volatile char *at = buffer + replay_line(kind, i) * line;
        (void)*at;
    }
}

#define TOUCH(kind)                                                                                          \
    static __attribute__((noinline)) void touch_##kind(const volatile char *buffer, size_t line)             \
    {                                                                                                        \
        touch(buffer, kind, line);                                                                           \
    }
TOUCH(0)
TOUCH(1)
TOUCH(2)
TOUCH(3)
TOUCH(4)

int main(int argc, char **argv)
{
    static void (*const touches[REPLAY_COUNT])(const volatile char *, size_t) = {touch_0, touch_1, touch_2,
                                                                                 touch_3, touch_4};
    size_t line = argc == 2 ? strtoul(argv[1], NULL, 10) : 0;
    for (int kind = 0; line && kind < REPLAY_COUNT; kind++) {
        char *buffer = aligned_alloc(MEGABYTE, MEGABYTE);
        if (!buffer)
            return 1;
        touches[kind](buffer, line);
    }
    return line ? 0 : 1;
}

/* What an engine of every size takes of memory, as the kernel counts it, against what it says that it may take at most.
 * AddressSanitizer keeps what was freed, so this test is built without it (tests/CMakeLists.txt). */
#include "check.h"
#include <malloc.h>
#include <stdlib.h>
#include "profile/reuse.h"

/* So many that a window of twice as many again is just not enough: then two of nearly four points a line stand at once. */
enum { LINES = (1 << 19) + 6000, ROUNDS = 8, CHUNK = 6000 };

static double read_bytes(const char *name)
{
    char line[256];
    double kib = 0;
    FILE *file = fopen("/proc/self/status", "r");
    assert_non_null(file);
    while (fgets(line, sizeof line, file))
        if (strncmp(line, name, strlen(name)) == 0)
            kib = strtod(line + strlen(name), NULL);
    fclose(file);
    return 1024 * kib;
}

static double peak(uint32_t numbers, uint32_t sectors)
{
    static uint32_t chunk[CHUNK];
    double before = read_bytes("VmSize:");
    struct aob_reuse *reuse = aob_reuse_create(numbers, sectors);
    for (uint64_t at = 0; at < (uint64_t)ROUNDS * numbers; at += CHUNK) {
        for (uint64_t i = 0; i < CHUNK; i++)
            chunk[i] = (uint32_t)((at + i) % numbers);
        aob_reuse_access(reuse, chunk, CHUNK);
    }
    aob_reuse_destroy(reuse);
    return read_bytes("VmPeak:") - before;
}

static void takes_what_it_says(void **state)
{
    (void)state;
    double lines = peak(LINES, 1), says = aob_reuse_bytes(LINES, 1);
    if (!(lines <= says + 0x1p20 && lines >= 0.95 * says))
        fail_msg("it took %.1f MiB and says %.1f", lines / 0x1p20, says / 0x1p20);
    double sectors = peak(2 * LINES, 2);
    says = aob_reuse_bytes(2 * LINES, 2);
    if (!(sectors <= says + 0x1p20 && sectors >= 0.95 * says))
        fail_msg("with sectors it took %.1f MiB and says %.1f", sectors / 0x1p20, says / 0x1p20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(takes_what_it_says)};
    mallopt(M_MMAP_THRESHOLD, 1 << 16); /* arrays lie by themselves, and go when they are freed */
    return cmocka_run_group_tests(tests, NULL, NULL);
}

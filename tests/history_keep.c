/* history_keep F.db NAME DATE RUN [SUMMARY]: keeps the run's folder as a night of the config NAME that began at DATE (seconds
 * since 1970); with SUMMARY, a JSON text, the night is ended. It prints the night's id and how many points it has. */
#include <stdio.h>
#include <stdlib.h>
#include "history/line.h"
#include "history/night.h"

int main(int argc, char **argv)
{
    struct aob_error error = {{0}};
    size_t taken = 0;
    if (argc < 5)
        return fprintf(stderr, "history_keep F.db NAME DATE RUN [SUMMARY]\n"), 2;
    struct aob_history *history = aob_history_open(argv[1], AOB_HISTORY_WRITE, &error);
    const struct aob_night_desc desc = {.name = argv[2],
                                        .config_hash = "c0ffee",
                                        .folder = argv[4],
                                        .modules = "m",
                                        .date = strtoll(argv[3], NULL, 10)};
    int64_t night = history ? aob_night_begin(history, &desc, &error) : 0;
    bool ok = night && aob_night_take(history, night, &taken, &error) &&
              (argc == 5 || aob_night_end(history, night, argv[5], &error));
    if (ok)
        printf("%lld %zu\n", (long long)night, taken);
    else
        aob_error_print(&error);
    aob_history_close(history);
    return ok ? 0 : 2;
}

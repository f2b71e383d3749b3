/* The table of metrics as docs/design.md has it: a line for each. */
#include <stdio.h>
#include "store/metric.h"

int main(void)
{
    static const char *const better[] = {"\u2013", "less", "more", "nearer to 0"};
    for (const struct aob_metric *m = aob_metric_table; m->name; m++)
        printf("| `%s%s%s` | %s | %s | %s |\n", m->group ? m->group : "", m->group ? "." : "", m->name,
               m->title, better[m->better], m->doc);
    return 0;
}

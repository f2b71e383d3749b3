/* The cache figures of a row: the member `cache` of its record (docs/design.md, Cache figures). */
#ifndef AOB_REPORTS_PAGE_CACHE_FIGURES_H
#define AOB_REPORTS_PAGE_CACHE_FIGURES_H
#include "base/text.h"
#include "rows.h"

/* Of the frame, by profile and level; NULL where the row has none. `level` -1 is the last one. */
const json_t *aob_row_cache_level(const struct aob_row *row, const char *profile, int level);

struct aob_cache_column { /* a figure of a level, as the record calls it */
    const char *profile, *level, *flight, *name;
    int place; /* of the level */
};
/* Every figure of every level of every profile that some row has, in the order of the records: the columns of cases.csv.
 * Texts belong to the rows; free() the list. */
struct aob_cache_column *aob_cache_columns(const struct aob_rows *rows, size_t *count);
double aob_cache_column_value(const struct aob_cache_column *column,
                              const struct aob_row *row); /* NAN: none */

/* The names of the profiles that some row of the section has good figures of, as keys of an object. decref it. */
json_t *aob_section_profiles(const struct aob_rows *rows, size_t section);
#endif

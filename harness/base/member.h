/* Members of a journal's objects, which may be absent or of another type. */
#ifndef AOB_BASE_MEMBER_H
#define AOB_BASE_MEMBER_H
#include <jansson.h>

/* The member, or "" / NaN. `object` may be NULL. */
const char *aob_member_text(const json_t *object, const char *name);
double aob_member_number(const json_t *object, const char *name);

/* "0.5", "cosine", "yes"; free() it. */
char *aob_member_show(const json_t *value);
#endif

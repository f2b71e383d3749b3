/* A module made for an interface that this program no longer has. */
#include <aobudget/technique.h>

extern const struct aob_module aob_module;
const struct aob_module aob_module = {3u << 16, sizeof(struct aob_module), NULL};

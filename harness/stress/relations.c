#include "groups.h"

const struct aob_property aob_properties_relations[] = {
    {0},
};

#include "groups.h"

const struct aob_property aob_properties_near[] = {
    {0},
};

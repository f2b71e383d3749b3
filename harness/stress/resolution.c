#include "groups.h"

const struct aob_property aob_properties_resolution[] = {
    {0},
};

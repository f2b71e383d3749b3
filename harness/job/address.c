#include "address.h"
#include "base/json.h"

json_t *aob_address_to_json(const struct aob_address *address)
{
    return json_pack("{s:s, s:o, s:s}", "name", address->technique, "module", aob_json_path(address->module),
                     "digest", address->digest);
}

bool aob_address_from_json(const json_t *object, struct aob_address *address, struct aob_error *error)
{
    *address = (struct aob_address){.technique = json_string_value(json_object_get(object, "name")),
                                    .module = json_string_value(json_object_get(object, "module")),
                                    .digest = json_string_value(json_object_get(object, "digest"))};
    return (address->technique && address->digest) ||
           aob_fail(error, "a job's technique has no name or no digest");
}

#include "member.h"
#include "json.h"
#include "memory.h"
#include "text.h"

const char *aob_member_text(const json_t *object, const char *name)
{
    const char *text = json_string_value(json_object_get(object, name));
    return text ? text : "";
}

double aob_member_number(const json_t *object, const char *name)
{
    return aob_json_to_number(json_object_get(object, name));
}

char *aob_member_show(const json_t *value)
{
    struct aob_text text = {0};
    if (json_is_string(value))
        aob_text_add(&text, "%s", json_string_value(value));
    else if (json_is_number(value))
        aob_text_add(&text, "%.6g", json_number_value(value));
    else if (json_is_boolean(value))
        aob_text_add(&text, "%s", json_is_true(value) ? "yes" : "no");
    else
        aob_text_add(&text, "%s", "?");
    return text.data ? text.data : aob_strdup("");
}

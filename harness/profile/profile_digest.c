#include "base/text.h"
#include "profile.h"

void aob_profile_digest(const struct aob_profile *profile, char digest[AOB_KEY_SIZE])
{
    struct aob_text text = {0};
    for (size_t i = 0; i < profile->fact_count; i++)
        aob_text_add(&text, "%s=%s\n", profile->facts[i].key, profile->facts[i].value);
    aob_hash_text(text.data, digest);
    aob_text_finish(&text);
}

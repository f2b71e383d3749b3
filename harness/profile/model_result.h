/* The modelled times of a result: what its profile's device would take for each pass and for the frame. */
#ifndef AOB_PROFILE_MODEL_RESULT_H
#define AOB_PROFILE_MODEL_RESULT_H
#include "model.h"

/* Whether there can be any: the profile has rates, and what each pass executed is known. */
bool aob_model_result_known(const struct aob_cache_result *result);

struct aob_model_time aob_model_result_pass(const struct aob_cache_result *result,
                                            const struct aob_cache_pass *pass);
struct aob_model_time aob_model_result_frame(const struct aob_cache_result *result);

/* The member `modelled` of docs/design.md, "Cache figures"; null where there can be none. */
json_t *aob_model_result_to_json(const struct aob_cache_result *result);
#endif
